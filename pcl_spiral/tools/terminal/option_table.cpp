// SPDX-License-Identifier: BSD-3-Clause
#include "option_table.h"

#include <pcl_spiral/common/impl/thread_limit.h>

#include <algorithm>
#include <numeric>

namespace {

/** Least number of letters to change, add or drop (Levenshtein 1966). */
std::size_t
editDistance(const std::string& a, const std::string& b)
{
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i - 1] != b[j - 1]);
      diagonal = row[j];
      row[j] = std::min({changed, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

} // namespace

void
addOptions(OptionGroup& group, const std::vector<Option>& more)
{
  group.options.insert(group.options.end(), more.begin(), more.end());
}

const Option*
findOption(const OptionTable& table, const std::string& name)
{
  for (const OptionGroup& group : table)
    for (const Option& option : group.options)
      if (option.name == name)
        return &option;
  return nullptr;
}

std::string
suggestion(const OptionTable& table, const std::string& name)
{
  std::string nearest;
  std::size_t least = std::max<std::size_t>(3, name.size() / 2);
  for (const OptionGroup& group : table)
    for (const Option& option : group.options) {
      const bool begins = name.size() >= 3 && option.name.rfind(name, 0) == 0;
      const std::size_t distance = begins ? 0 : editDistance(name, option.name);
      if (distance < least) {
        least = distance;
        nearest = option.name;
      }
    }
  return nearest.empty() ? std::string() : "; did you mean '" + nearest + "'?";
}

bool
mayRepeat(const OptionTable& table, const std::string& name)
{
  const Option* const option = findOption(table, name);
  return option && option->repeats;
}

Option
numberOption(const std::string& name, const std::string& argument, const std::string& help, double& target)
{
  return {name, argument, help, [name, &target](const std::string& value) { target = numberValue(name, value); }};
}

Option
wholeNumberOption(const std::string& name, const std::string& argument, const std::string& help, int& target)
{
  return {name, argument, help, [name, &target](const std::string& value) { target = wholeNumberValue(name, value); }};
}

Option
threadsOption(const std::string& why, unsigned int& target)
{
  return {"threads", "N", "number of threads; default 0, all; " + why + ": --threads 4", [&target](const std::string& value) {
            const int threads = wholeNumberValue("threads", value);
            requireOption(threads >= 0 && threads <= static_cast<int>(pcl_spiral::most_threads), "threads", threads,
                          "must be from 1 to 256, or 0 for all");
            target = static_cast<unsigned int>(threads);
          }};
}

Option
textOption(const std::string& name, const std::string& argument, const std::string& help, std::string& target)
{
  return {name, argument, help, [&target](const std::string& value) { target = value; }};
}

Option
switchOption(const std::string& name, const std::string& help, bool& target)
{
  return {name, "", help, [name, &target](const std::string& value) {
            if (value != "true" && value != "false")
              throw UsageError(pcl_spiral::Diagnostic(name, ": ", value, ": must be true or false"));
            target = value == "true";
          }};
}
