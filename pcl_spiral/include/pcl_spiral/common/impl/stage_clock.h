/** \file
 *  What the stages of a run cost: time and memory.
 */
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

namespace pcl_spiral {

/** Memory of this process, bytes, as Linux counts it in /proc/self/status, to about 1 MB; 0 where that is not known. */
struct MemoryUse {
  std::size_t resident = 0; ///< in main memory now (VmRSS): the process's own and the pages of libraries it touched
  std::size_t peak = 0;     ///< the most there has been since the process began (VmHWM)
};

MemoryUse
memoryUse();

/** Wall time of one stage, and the memory of the whole process at its end. A stage that raised the peak is one whose peak
 *  exceeds that of the stage before. */
struct StageCost {
  std::string name;
  double seconds = 0.0;
  MemoryUse memory;
};

/** Times one stage after the other. */
class StageClock {
public:
  /** The first stage begins now. \p stages must outlive the clock. */
  explicit StageClock(std::vector<StageCost>& stages) : stages_(stages), begin_(std::chrono::steady_clock::now()) {}

  /** The stage that ran until now was \p name; the next one begins. */
  void end(const std::string& name);
  /** The next stage begins now; what ran until now is told elsewhere. */
  void restart() { begin_ = std::chrono::steady_clock::now(); }

private:
  std::vector<StageCost>& stages_;
  std::chrono::steady_clock::time_point begin_;
};

} // namespace pcl_spiral
