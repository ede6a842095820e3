// SPDX-License-Identifier: BSD-3-Clause
#include "available_memory.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>

#ifdef __unix__
#include <sys/resource.h>
#endif

namespace pcl_spiral {
namespace {

/** The value of a line "key 123 kB" of a file of /proc, bytes. */
std::optional<double>
procValue(const char* file, const std::string& wanted)
{
  std::ifstream lines(file);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string key;
    double kibibytes = 0.0;
    if (words >> key >> kibibytes && key == wanted)
      return 1024.0 * kibibytes;
  }
  return std::nullopt;
}

} // namespace

std::optional<double>
availableMemory()
{
  double least = procValue("/proc/meminfo", "MemAvailable:").value_or(std::numeric_limits<double>::infinity());
#ifdef __unix__
  rlimit limit{};
  if (::getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
    if (const auto used = procValue("/proc/self/status", "VmSize:"))
      least = std::min(least, std::max(0.0, static_cast<double>(limit.rlim_cur) - *used));
#endif
  return least < std::numeric_limits<double>::infinity() ? std::optional<double>(least) : std::nullopt;
}

} // namespace pcl_spiral
