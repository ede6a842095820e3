// SPDX-License-Identifier: BSD-3-Clause
#include "table.h"

#include <cmath>
#include <cstdio>

namespace pcl_spiral::acceptance {

Table::Table(const std::string& title)
{
  std::printf("%s\n  %-34s %14s %14s\n", title.c_str(), "", "measured", "limit");
}

void
Table::note(const std::string& name, double value, const std::string& unit)
{
  std::printf("  %-34s %14.6g %14s %s\n", name.c_str(), value, "", unit.c_str());
}

void
Table::note(const std::string& name, const std::string& text)
{
  std::printf("  %-34s %s\n", name.c_str(), text.c_str());
}

void
Table::atMost(const std::string& name, double value, double limit, const std::string& unit)
{
  const bool held = value <= limit; // false for NaN
  broken_ += held ? 0 : 1;
  std::printf("  %-34s %14.6g %14.6g %s%s\n", name.c_str(), value, limit, unit.c_str(), held ? "" : "  BROKEN");
  std::fflush(stdout);
}

void
Table::atMost(const std::string& name, const test::Place& place, double limit, const std::string& unit)
{
  atMost(name, std::abs(place.value), limit, unit);
  if (!(std::abs(place.value) <= limit))
    std::printf("    %s\n", text(place).c_str());
}

void
Table::holds(const std::string& name, bool held, const std::string& text)
{
  broken_ += held ? 0 : 1;
  std::printf("  %-34s %s%s%s\n", name.c_str(), held ? "yes" : "NO  BROKEN", text.empty() ? "" : ": ", text.c_str());
  std::fflush(stdout);
}

std::string
text(const test::Place& place)
{
  char buffer[200];
  std::snprintf(buffer, sizeof buffer, "%.6g at (%.3f %.3f %.3f), %.3f from the rim, turn %.3f, path index %zu", place.value, place.at.x(),
                place.at.y(), place.at.z(), place.rim, place.turn, place.index);
  return buffer;
}

} // namespace pcl_spiral::acceptance
