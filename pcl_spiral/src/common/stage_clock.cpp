// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/common/impl/stage_clock.h>

#include <fstream>
#include <sstream>

namespace pcl_spiral {

MemoryUse
memoryUse()
{
  MemoryUse use;
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    std::istringstream words(line);
    std::string key;
    std::size_t kibibytes = 0;
    if (!(words >> key >> kibibytes))
      continue;
    if (key == "VmRSS:")
      use.resident = 1024 * kibibytes;
    if (key == "VmHWM:")
      use.peak = 1024 * kibibytes;
  }
  return use;
}

void
StageClock::end(const std::string& name)
{
  const auto now = std::chrono::steady_clock::now();
  stages_.push_back({name, std::chrono::duration<double>(now - begin_).count(), memoryUse()});
  begin_ = now;
}

} // namespace pcl_spiral
