// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Runs the same program again, so that a measurement has its own process and its own peak of memory.
 */
#pragma once

#include "measured_run.h"

namespace pcl_spiral::benchmarks {

/** The measurement of a child process. */
struct ChildTask {
  std::string what; ///< "ours" or "pcl"
  std::string name; ///< of the case
  double scallop = 0.0;
  int threads = 0;
  std::string folder; ///< folder of the scan, the path and the result
};

/** The scan of the folder. */
std::string scanIn(const std::string& folder);

/** Runs it in a separate process. \throw std::runtime_error with its message if it fails */
Json runChild(const ChildTask& task);

/** Whether the program was called by runChild. */
bool isChild(int argc, char** argv);

/** Runs the measurement in the child process; returns the exit code. */
int childMain(int argc, char** argv);

} // namespace pcl_spiral::benchmarks
