// SPDX-License-Identifier: BSD-3-Clause
#include "post_text.h"

#include <charconv>

namespace pcl_spiral {
namespace {

constexpr std::size_t full = 1 << 20; ///< bytes to write at once

} // namespace

std::string
plainText(std::string text, std::string_view others)
{
  for (char& c : text)
    if (c < ' ' || c > '~' || others.find(c) != std::string_view::npos)
      c = ' ';
  return text;
}

void
PostText::numberLines(std::string_view letter, std::size_t first, std::size_t step, std::size_t last)
{
  letter_ = letter;
  next_ = first;
  step_ = step;
  last_ = last;
}

/** What stands before a word: a space, or the number of its line. */
void
PostText::separate()
{
  if (!at_start_)
    bytes_ += ' ';
  else if (step_ > 0) {
    bytes_ += letter_ + std::to_string(next_) + ' ';
    next_ = next_ + step_ > last_ ? step_ : next_ + step_;
  }
  at_start_ = false;
}

void
PostText::code(std::string_view word)
{
  separate();
  bytes_ += word;
}

void
PostText::word(std::string_view letters, double value)
{
  word(letters, value, decimals_);
}

void
PostText::word(std::string_view letters, double value, int decimals, bool signs)
{
  separate();
  bytes_ += letters;
  number(value, decimals, signs);
}

void
PostText::number(double value, int decimals, bool signs)
{
  char digits[400]; // the largest double has 309 before the point
  const char* const end = std::to_chars(digits, digits + sizeof digits, value, std::chars_format::fixed, decimals).ptr;
  std::string_view number(digits, static_cast<std::size_t>(end - digits));
  if (number[0] == '-' && number.find_first_not_of("-0.") == std::string_view::npos)
    number.remove_prefix(1); // no sign on zero
  if (signs && number[0] != '-')
    bytes_ += '+';
  bytes_ += number;
}

void
PostText::endLine(std::string_view end)
{
  bytes_ += end;
  at_start_ = true;
  if (bytes_.size() > full) {
    file_.write(bytes_);
    bytes_.clear();
  }
}

void
PostText::close()
{
  file_.write(bytes_);
  bytes_.clear();
  file_.close();
}

void
writeVector(PostText& out, const std::array<std::string_view, 3>& letters, const Eigen::Vector3d& v, bool signs)
{
  for (int i = 0; i < 3; ++i)
    out.word(letters[i], v[i], 8, signs);
}

std::string
commentText(const std::string& title)
{
  return plainText(title, "()[]{};\"%");
}

} // namespace pcl_spiral
