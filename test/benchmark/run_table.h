// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What whole runs came to, for people.
 */
#pragma once

#include "measured_run.h"

namespace pcl_spiral::benchmarks {

/** One run beside PCL's pair: times, ratio, memory, accuracy, and its stages. */
void printRun(const Json& run);

/** All of them, a line each, as a table in Markdown. */
void printTable(const Json& runs);

} // namespace pcl_spiral::benchmarks
