// SPDX-License-Identifier: BSD-3-Clause
#include "support/typed_words.h"

#include <algorithm>
#include <sstream>

namespace pcl_spiral::test {
namespace {

bool
isOption(const std::string& word)
{
  return word.rfind("--", 0) == 0;
}

/** Takes \p option out of \p command, with its value. */
void
leaveOut(const std::string& option, std::vector<std::string>& command)
{
  const auto given = std::find(command.begin(), command.end(), option);
  if (given == command.end())
    return;
  const auto behind = given + 1;
  command.erase(given, behind == command.end() || isOption(*behind) ? behind : behind + 1);
}

} // namespace

std::vector<std::string>
typedChange(std::vector<std::string> command, const std::string& change)
{
  bool without = false, takes_value = false;
  std::istringstream text(change);
  for (std::string word; text >> word;) {
    const bool is_option = isOption(word), is_last = word.back() == ',';
    if (is_last)
      word.pop_back();
    if (is_option && word != "--keep-out")
      leaveOut(word, command);
    if ((is_option && !without) || (takes_value && word != "and"))
      command.push_back(word);
    takes_value = is_option && !is_last && !without;
    without = word == "without";
  }
  return command;
}

} // namespace pcl_spiral::test
