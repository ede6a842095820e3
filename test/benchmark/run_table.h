// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Tables of the results of whole runs.
 */
#pragma once

#include "measured_run.h"

namespace pcl_spiral::benchmarks {

/** One run compared with PCL's pair: times, ratio, memory, accuracy, and its stages. */
void printRun(const Json& run);

/** All runs as a table in Markdown, one line per run. */
void printTable(const Json& runs);

} // namespace pcl_spiral::benchmarks
