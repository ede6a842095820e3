// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Time and memory that the stages of a run use.
 */
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

namespace pcl_spiral {

/** Memory of this process, bytes, as Linux reports it in /proc/self/status, to about 1 MB; 0 if not known. */
struct MemoryUse {
  std::size_t resident = 0; ///< in main memory now (VmRSS): of the process itself and of the library pages it used
  std::size_t peak = 0;     ///< the maximum since the process began (VmHWM)
};

MemoryUse memoryUse();

/** Wall time of one stage, and the memory of the whole process at its end. If the peak is above that of the stage before, this
 *  stage raised it. */
struct StageCost {
  std::string name;
  double seconds = 0.0;
  MemoryUse memory;
};

/** Measures the time of one stage after another. */
class StageClock {
public:
  /** Start the first stage. \p stages must outlive the clock. */
  explicit StageClock(std::vector<StageCost>& stages) : stages_(stages), begin_(std::chrono::steady_clock::now()) {}

  /** End the stage \p name and start the next one. */
  void end(const std::string& name);
  /** Start the next stage; the time until now is reported elsewhere. */
  void restart() { begin_ = std::chrono::steady_clock::now(); }

private:
  std::vector<StageCost>& stages_;
  std::chrono::steady_clock::time_point begin_;
};

} // namespace pcl_spiral
