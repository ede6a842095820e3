// SPDX-License-Identifier: BSD-3-Clause
#include "program_words.h"

#include "io/link_marks.h"

#include <pcl_spiral/io/file_error.h>

#include <algorithm>
#include <cctype>

namespace pcl_spiral {
namespace {

bool
isLetter(char c)
{
  return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_';
}

bool
isDigit(char c)
{
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

bool
isBlank(char c)
{
  return c == ' ' || c == '\t';
}

/** The first character from \p at on that does not pass \p test. */
template <typename Test>
std::size_t
endOf(std::string_view text, std::size_t at, const Test& test)
{
  while (at < text.size() && test(text[at]))
    ++at;
  return at;
}

} // namespace

void
ProgramLines::fail(const ProgramWord& word, const Diagnostic& reason) const
{
  fail(Diagnostic(word.text, ": ", reason));
}

void
ProgramLines::fail(const Diagnostic& reason) const
{
  throw FileError(file_, atLine(lines_.number(), reason));
}

bool
ProgramLines::next()
{
  while (lines_.next(text_)) {
    split();
    if (!words_.empty())
      return true;
  }
  return false;
}

void
ProgramLines::split()
{
  words_.clear();
  for (std::size_t at = 0; at < text_.size();) {
    if (isBlank(text_[at]) || text_[at] == '%') // % is the begin or the end of a tape
      ++at;
    else if (text_[at] == '(' || text_[at] == ';')
      at = takeComment(at);
    else
      at = takeWord(at);
  }
}

std::size_t
ProgramLines::takeComment(std::size_t begin)
{
  const std::size_t close = text_[begin] == '(' ? text_.find(')', begin) : text_.size();
  if (close == std::string_view::npos)
    fail("a comment begins with ( and does not end; add )");
  comments_.emplace_back(text_.substr(begin + 1, close - begin - 1));
  in_link_ = isInLink(trimmed(comments_.back()), in_link_);
  return std::min(close + 1, text_.size());
}

std::size_t
ProgramLines::takeWord(std::size_t begin)
{
  const bool klartext_name = !words_.empty() && (words_.back().name == "PGM" || words_.back().name == "DEF");
  if (klartext_name) { // of a program, or of a cycle with its values
    words_.push_back({"", std::nullopt, std::string(text_.substr(begin))});
    return text_.size();
  }
  const bool number_only = words_.empty() && isDigit(text_[begin]); // the number of a line of Klartext
  if (!number_only && !isLetter(text_[begin]))
    fail(Diagnostic(inQuotes(text_.substr(begin)),
                    " is not understood: the program is read without variables, expressions, labels and skipped blocks; "
                    "write every move with numbers"));
  std::size_t at = number_only ? begin : endOf(text_, begin, isLetter);
  ProgramWord word;
  word.name = text_.substr(begin, at - begin);
  if (const std::size_t digits = endOf(text_, at, isDigit); digits < text_.size() && text_[digits] == '=' && digits > begin) {
    word.name = text_.substr(begin, digits - begin);
    at = digits + 1;
  }
  std::transform(word.name.begin(), word.name.end(), word.name.begin(), [](unsigned char c) { return std::toupper(c); });
  const std::size_t value = endOf(text_, at, isBlank);
  const auto inNumber = [](char c) { return isDigit(c) || c == '.'; };
  std::size_t end = value < text_.size() && (text_[value] == '+' || text_[value] == '-') ? value + 1 : value;
  end = endOf(text_, end, inNumber);
  if (end > value) {
    const std::string_view digits = text_.substr(value, end - value);
    word.value = toNumber(digits[0] == '+' ? digits.substr(1) : digits);
    if (!word.value)
      fail(Diagnostic(inQuotes(text_.substr(begin, end - begin)), " has no number that can be read; write it as X-12.5"));
  }
  const std::size_t behind = word.value ? end : at;
  word.text = text_.substr(begin, behind - begin);
  words_.push_back(std::move(word));
  return behind;
}

} // namespace pcl_spiral
