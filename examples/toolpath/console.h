/** \file
 *  The summary of a run on a terminal.
 */
#pragma once

#include "job.h"

#include <pcl_spiral/toolpath/spiral_report.h>

/** What was made, for people. */
void printSummary(const Job& job, const pcl_spiral::SpiralReport& report, double seconds);
