// SPDX-License-Identifier: BSD-3-Clause
#include "method_name.h"

#include "io/setting_names.h"

#include <cstdio>

namespace pcl_spiral::acceptance {

std::optional<SpiralMethod>
methodNamed(const std::string& name)
{
  for (const auto& [method, word] : ChoiceNames<SpiralMethod>::words)
    if (!name.empty() && std::string(word).compare(0, name.size(), name) == 0)
      return method;
  return std::nullopt;
}

bool
isMethod(const std::string& name)
{
  if (methodNamed(name))
    return true;
  std::printf("no method begins with '%s'; there are %s\n", name.c_str(), choiceList<SpiralMethod>().c_str());
  return false;
}

} // namespace pcl_spiral::acceptance
