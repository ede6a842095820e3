// SPDX-License-Identifier: BSD-3-Clause
#include "idle_options.h"

#include "terminal.h"

#include <algorithm>
#include <iterator>
#include <utility>

using namespace pcl_spiral;

namespace {

/** Names of tables and options that differ by more than their dashes. */
constexpr std::pair<const char*, const char*> other_names[] = {
    {"gouge_check", "no-gouge-check"}, {"keep_outs", "keep-out"}, {"regions", "region"}, {"zigzag", "one-way"}, {"closed", "ring"},
    {"outlier_neighbours", "outliers"}};

std::string
replaced(std::string name, char from, char to)
{
  std::replace(name.begin(), name.end(), from, to);
  return name;
}

} // namespace

AskedNames
askedNames(const std::set<std::string>& given)
{
  AskedNames names;
  for (const std::string& option : given) {
    const auto* other =
        std::find_if(std::begin(other_names), std::end(other_names), [&option](const auto& pair) { return option == pair.second; });
    names.insert(other != std::end(other_names) ? other->first : replaced(option, '-', '_'));
  }
  return names;
}

void
requireUsed(const std::optional<IdleSetting>& idle)
{
  if (!idle)
    return;
  const auto* other =
      std::find_if(std::begin(other_names), std::end(other_names), [&idle](const auto& pair) { return idle->name == pair.first; });
  throw UsageError(
      Diagnostic("--", other != std::end(other_names) ? std::string(other->second) : replaced(idle->name, '_', '-'), idle->remedy));
}
