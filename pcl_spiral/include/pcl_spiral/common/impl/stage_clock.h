// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Time and memory that the stages of a run use.
 */
#pragma once

#include <chrono>
#include <cstddef>
#include <pcl_spiral/common/status.h>
#include <string>
#include <vector>

namespace pcl_spiral {

MemoryUse memoryUse();

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
