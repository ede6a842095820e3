// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The same program once more, so that a measurement has a process, and a peak of memory, of its own.
 */
#pragma once

#include "measured_run.h"

namespace pcl_spiral::benchmarks {

/** What a child measures. */
struct ChildTask {
  std::string what; ///< "ours" or "pcl"
  std::string name; ///< of the case
  double scallop = 0.0;
  int threads = 0;
  std::string folder; ///< where the scan is, and where the path and the result go
};

/** The scan of the folder. */
std::string scanIn(const std::string& folder);

/** Run it in a process of its own. \throw std::runtime_error with its message where it fails */
Json runChild(const ChildTask& task);

/** Whether the program was called by runChild. */
bool isChild(int argc, char** argv);

/** Do what runChild asks, in the child; the exit code. */
int childMain(int argc, char** argv);

} // namespace pcl_spiral::benchmarks
