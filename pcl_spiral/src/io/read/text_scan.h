// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Lines, words and numbers of a text in memory.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pcl_spiral {

/** Reads a text line by line; lines may end in LF, CR LF or CR. The mark of UTF-8 before the first line is passed over. */
class LineScanner {
public:
  explicit LineScanner(std::string_view text);

  /** The next line without its end and without spaces around it; false at the end of the text. */
  bool next(std::string_view& line);
  /** Number of the last line from next, from 1. */
  std::size_t number() const { return number_; }
  /** Byte where the next line begins. */
  std::size_t position() const { return position_; }

private:
  std::string_view text_;
  std::size_t position_ = 0;
  std::size_t number_ = 0;
};

/** Reads a text word by word; words are separated by spaces and ends of lines. */
class WordScanner {
public:
  /** \p lines: where to begin; their number counts on. */
  WordScanner(std::string_view text, const LineScanner& lines) : text_(text), position_(lines.position()), number_(lines.number() + 1) {}

  /** The next word; false at the end of the text. */
  bool next(std::string_view& word);
  /** Number of the line of the last word from next, from 1. */
  std::size_t number() const { return number_; }

private:
  std::string_view text_;
  std::size_t position_;
  std::size_t number_;
};

/** Bytes of the mark of UTF-8 (byte order mark) that \p text begins with: 3 or 0. */
std::size_t utf8Mark(std::string_view text);

/** Removes spaces at both ends. */
std::string_view trimmed(std::string_view text);

/** Words separated by spaces (separator ' ') or by a character; spaces around a word are removed, empty words
 * are kept. */
void splitWords(std::string_view line, char separator, std::vector<std::string_view>& words);

/** The word without the quotes around it, " or ', and without spaces inside these. */
std::string_view unquoted(std::string_view word);

/** The separator of the columns of a line: a semicolon, else a comma, else spaces. */
char separatorOf(std::string_view line);

/** Whether \p word is \p lower in any mixture of upper and lower case. */
bool sameWord(std::string_view word, std::string_view lower);

/** The whole word as a number; nan and inf are numbers too. */
std::optional<double> toNumber(std::string_view word);

/** The whole word as a count: whole, not negative, below 1e15. */
std::optional<std::size_t> toCount(std::string_view word);

/** "line 7: what" */
Diagnostic atLine(std::size_t number, const Diagnostic& what);

/** A count for a message, without decimals. */
std::string wholeNumber(double value);

/** A word for a message: in quotes, cut after 40 characters, without control characters. */
std::string inQuotes(std::string_view word);

} // namespace pcl_spiral
