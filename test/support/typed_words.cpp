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
  const std::size_t end = change.rfind("without ", 0) == 0 ? 0 : std::min(change.find(", "), change.size());
  std::istringstream settings(change.substr(0, end)), aside(change.substr(end));
  std::vector<std::string> pasted;
  for (std::string word; settings >> word; pasted.push_back(word))
    if (isOption(word) && word != "--keep-out")
      leaveOut(word, command);
  for (std::string word, before; aside >> word; before = word)
    if (before == "without")
      leaveOut(word.substr(0, word.find(',')), command);
  command.insert(command.end(), pasted.begin(), pasted.end());
  return command;
}

} // namespace pcl_spiral::test
