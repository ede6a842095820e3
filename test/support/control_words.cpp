// SPDX-License-Identifier: BSD-3-Clause
#include "support/control_words.h"

#include "support/control_state.h"

#include <algorithm>
#include <cctype>
#include <regex>
#include <sstream>

namespace pcl_spiral::test {
namespace {

/** A number with at most one sign and one point, as controls read it. */
double
numberOf(const std::string& digits, const std::string& word)
{
  static const std::regex shape("[+-]?([0-9]+\\.?[0-9]*|\\.[0-9]+)");
  if (!std::regex_match(digits, shape))
    throw ControlFault("'" + word + "' has no number");
  std::istringstream stream(digits[0] == '+' ? digits.substr(1) : digits);
  stream.imbue(std::locale::classic());
  double value = 0.0;
  stream >> value;
  return value;
}

} // namespace

ControlWords
ControlWords::letters(const std::string& line)
{
  ControlWords words;
  for (std::size_t at = 0; at < line.size();) {
    if (line[at] == ' ') {
      ++at;
      continue;
    }
    const std::size_t end = std::min(line.size(), line.find_first_not_of("+-.0123456789", at + 1));
    const std::string name = line.substr(at, 1), digits = line.substr(at + 1, end - at - 1);
    if (!std::isupper(static_cast<unsigned char>(name[0])))
      throw ControlFault("'" + line.substr(at) + "' is no word");
    words.words_.push_back({name, digits, numberOf(digits, line.substr(at, end - at))});
    at = end;
  }
  return words;
}

ControlWords
ControlWords::spaced(const std::string& line)
{
  static const std::regex plain("([A-Z]+)([+-]?[0-9.]+)"), assigned("([A-Z][A-Z0-9]*)=([+-]?[0-9.]+)");
  ControlWords words;
  std::istringstream stream(line);
  for (std::string word; stream >> word;) {
    std::smatch parts;
    if (std::regex_match(word, parts, plain) || std::regex_match(word, parts, assigned))
      words.words_.push_back({parts[1], parts[2], numberOf(parts[2], word)});
    else
      words.words_.push_back({word, {}, 0.0});
  }
  return words;
}

std::vector<ControlWord>
ControlWords::takeAll(const std::string& name)
{
  const auto others = std::stable_partition(words_.begin(), words_.end(), [&](const ControlWord& word) { return word.name != name; });
  std::vector<ControlWord> taken(others, words_.end());
  words_.erase(others, words_.end());
  return taken;
}

std::optional<ControlWord>
ControlWords::take(const std::string& name)
{
  const std::vector<ControlWord> taken = takeAll(name);
  if (taken.size() > 1)
    throw ControlFault("the word " + name + " twice");
  return taken.empty() ? std::nullopt : std::optional<ControlWord>(taken[0]);
}

std::optional<double>
ControlWords::value(const std::string& name)
{
  const std::optional<ControlWord> word = take(name);
  if (word && word->digits.empty())
    throw ControlFault("the word " + name + " without a number");
  return word ? std::optional<double>(word->value) : std::nullopt;
}

std::optional<Eigen::Vector3d>
ControlWords::vector(const std::array<std::string, 3>& names)
{
  const std::optional<double> x = value(names[0]), y = value(names[1]), z = value(names[2]);
  if (!x && !y && !z)
    return std::nullopt;
  if (!x || !y || !z)
    throw ControlFault("the vector " + names[0] + " " + names[1] + " " + names[2] + " is not complete");
  const Eigen::Vector3d vector(*x, *y, *z);
  if (std::abs(vector.norm() - 1.0) > 1e-6)
    throw ControlFault("the vector " + names[0] + " " + names[1] + " " + names[2] + " is not of length 1");
  return vector;
}

void
ControlWords::requireNone() const
{
  if (!words_.empty())
    throw ControlFault("unknown word " + words_[0].name + words_[0].digits);
}

} // namespace pcl_spiral::test
