// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Words of the lines of a control program.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>

#include "text_scan.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pcl_spiral {

/** G43.4, A3=0.5, or a word without a number such as TRAORI. */
struct ProgramWord {
  std::string name;            ///< in upper case
  std::optional<double> value; ///< absent: a word without a number
  std::string text;            ///< as it stands there, for messages
};

/** The lines of a program, split into words; comments in ( ) and behind ; are left out. */
class ProgramLines {
public:
  ProgramLines(std::string file, std::string_view text) : file_(std::move(file)), lines_(text) {}

  /** The next line with words; false at the end. \throw FileError for what is no word: variables, expressions, skipped blocks */
  bool next();
  const std::vector<ProgramWord>& words() const { return words_; }
  /** The line as it stands there. */
  std::string_view text() const { return text_; }
  std::size_t number() const { return lines_.number(); }
  /** The comments of all lines up to here. */
  const std::vector<std::string>& comments() const { return comments_; }
  /** Whether the line is between the marks of a link between passes. */
  bool inLink() const { return in_link_; }

  /** "line 7: X10: reason" \throw FileError */
  [[noreturn]] void fail(const ProgramWord& word, const Diagnostic& reason) const;
  /** "line 7: reason" \throw FileError */
  [[noreturn]] void fail(const Diagnostic& reason) const;

private:
  void split();
  std::size_t takeComment(std::size_t begin);
  std::size_t takeWord(std::size_t begin);

  std::string file_;
  LineScanner lines_;
  std::string_view text_;
  std::vector<ProgramWord> words_;
  std::vector<std::string> comments_;
  bool in_link_ = false;
};

} // namespace pcl_spiral
