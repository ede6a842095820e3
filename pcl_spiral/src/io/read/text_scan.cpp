// SPDX-License-Identifier: BSD-3-Clause
#include "text_scan.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace pcl_spiral {
namespace {

bool
isBlank(char c)
{
  return c == ' ' || c == '\t';
}

} // namespace

std::size_t
utf8Mark(std::string_view text)
{
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  return text.substr(0, mark.size()) == mark ? mark.size() : 0;
}

LineScanner::LineScanner(std::string_view text) : text_(text), position_(utf8Mark(text)) {}

bool
WordScanner::next(std::string_view& word)
{
  const auto ends = [](char c) { return c == '\n' || c == '\r'; };
  for (; position_ < text_.size() && (isBlank(text_[position_]) || ends(text_[position_])); ++position_)
    if (text_[position_] == '\n' || (text_[position_] == '\r' && text_.substr(position_ + 1, 1) != "\n"))
      ++number_;
  const std::size_t begin = position_;
  while (position_ < text_.size() && !isBlank(text_[position_]) && !ends(text_[position_]))
    ++position_;
  word = text_.substr(begin, position_ - begin);
  return !word.empty();
}

bool
LineScanner::next(std::string_view& line)
{
  if (position_ >= text_.size())
    return false;
  std::size_t end = position_;
  while (end < text_.size() && text_[end] != '\n' && text_[end] != '\r')
    ++end;
  line = trimmed(text_.substr(position_, end - position_));
  const bool two = end + 1 < text_.size() && text_[end] == '\r' && text_[end + 1] == '\n';
  position_ = std::min(text_.size(), end + (two ? 2 : 1));
  ++number_;
  return true;
}

std::string_view
trimmed(std::string_view text)
{
  while (!text.empty() && isBlank(text.front()))
    text.remove_prefix(1);
  while (!text.empty() && isBlank(text.back()))
    text.remove_suffix(1);
  return text;
}

void
splitWords(std::string_view line, char separator, std::vector<std::string_view>& words)
{
  words.clear();
  if (separator != ' ') {
    for (std::size_t begin = 0; begin <= line.size();) {
      const std::size_t end = std::min(line.find(separator, begin), line.size());
      words.push_back(trimmed(line.substr(begin, end - begin)));
      begin = end + 1;
    }
    return;
  }
  for (std::size_t i = 0; i < line.size();) {
    while (i < line.size() && isBlank(line[i]))
      ++i;
    const std::size_t begin = i;
    while (i < line.size() && !isBlank(line[i]))
      ++i;
    if (i > begin)
      words.push_back(line.substr(begin, i - begin));
  }
}

std::string_view
unquoted(std::string_view word)
{
  if (word.size() >= 2 && (word.front() == '"' || word.front() == '\'') && word.back() == word.front())
    return trimmed(word.substr(1, word.size() - 2));
  return word;
}

char
separatorOf(std::string_view line)
{
  return line.find(';') != std::string_view::npos ? ';' : line.find(',') != std::string_view::npos ? ',' : ' ';
}

bool
sameWord(std::string_view word, std::string_view lower)
{
  return std::equal(word.begin(), word.end(), lower.begin(), lower.end(),
                    [](unsigned char a, unsigned char b) { return std::tolower(a) == b; });
}

std::optional<double>
toNumber(std::string_view word)
{
  if (word.size() > 1 && word[0] == '+' && word[1] != '-')
    word.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size())
    return std::nullopt;
  return value;
}

std::optional<std::size_t>
toCount(std::string_view word)
{
  constexpr double most = 1e15;
  const std::optional<double> value = toNumber(word);
  if (!value || !(*value >= 0.0 && *value < most) || *value != std::floor(*value))
    return std::nullopt;
  return static_cast<std::size_t>(*value);
}

Diagnostic
atLine(std::size_t number, const Diagnostic& what)
{
  return Diagnostic("line ", number, ": ", what);
}

std::string
wholeNumber(double value)
{
  const std::string text = std::to_string(value);
  return text.substr(0, text.find('.'));
}

std::string
inQuotes(std::string_view word)
{
  constexpr std::size_t longest = 40;
  std::string text = "'";
  for (const char c : word.substr(0, longest))
    text += static_cast<unsigned char>(c) < 32 || c == 127 ? '?' : c;
  return text + (word.size() > longest ? "...'" : "'");
}

} // namespace pcl_spiral
