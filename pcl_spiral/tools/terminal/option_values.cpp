// SPDX-License-Identifier: BSD-3-Clause
#include "option_values.h"

#include <pcl_spiral/core/diagnostic.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

double
numberValue(const std::string& name, const std::string& value)
{
  double result = 0.0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), result);
  if (error != std::errc() || end != value.data() + value.size() || !std::isfinite(result))
    throw UsageError(pcl_spiral::Diagnostic("--", name, " ", value, ": this is not a number; write it as 12.5"));
  return result;
}

void
requireOption(bool holds, const std::string& option, double value, const pcl_spiral::Diagnostic& rule)
{
  if (!holds)
    throw UsageError(pcl_spiral::Diagnostic("--", option, " ", pcl_spiral::Diagnostic(value), ": ", rule));
}

int
wholeNumberValue(const std::string& name, const std::string& value)
{
  constexpr double most = 1e9;
  const double result = numberValue(name, value);
  requireOption(std::abs(result) <= most, name, result,
                pcl_spiral::Diagnostic("must be from ", -static_cast<long long>(most), " to ", static_cast<long long>(most)));
  if (result != std::round(result))
    throw UsageError(pcl_spiral::Diagnostic("--", name, " ", value, ": this is not a whole number; write it as 4"));
  return static_cast<int>(result);
}

std::vector<std::string>
piecesOf(const std::string& value)
{
  std::vector<std::string> pieces;
  for (std::size_t begin = 0; begin <= value.size();) {
    const std::size_t end = std::min(value.find('/', begin), value.size());
    pieces.push_back(value.substr(begin, end - begin));
    begin = end + 1;
  }
  return pieces;
}

std::vector<std::string>
listValue(const std::string& value)
{
  std::vector<std::string> words;
  std::stringstream stream(value);
  for (std::string word; std::getline(stream, word, ',');) {
    word.erase(std::remove(word.begin(), word.end(), ' '), word.end());
    words.push_back(word);
  }
  return words;
}

Eigen::Vector3d
placeValue(const std::string& name, const std::string& value)
{
  const std::vector<std::string> words = listValue(value);
  if (words.size() != 3)
    throw UsageError(pcl_spiral::Diagnostic("--", name, " ", value, ": give three numbers separated by commas, such as 10,-5,120"));
  return {numberValue(name, words[0]), numberValue(name, words[1]), numberValue(name, words[2])};
}
