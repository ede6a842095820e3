// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The scan of a program that makes passes of a tool.
 */
#pragma once

#include "pass_job.h"
#include "pass_result.h"

/** Reads the scan of \p job and sets what of it all planners of passes take. \throw pcl_spiral::FileError */
template <typename Planner>
void
readPassScan(const PassJob& job, Planner& planner, PassResult& result)
{
  const pcl_spiral::Scan scan = pcl_spiral::readCloud(job.scan, job.read);
  setScanFrame(scan.shift, job.read);
  result.warnings = scan.warnings;
  result.asked_side = sideOf(scan, fromScan(job.view_point));
  planner.setInputCloud(scan.cloud);
  setSide(result.asked_side, planner);
  planner.setLargestPart(job.largest_part);
  planner.setThinning(job.thinning);
  planner.setLeaveOutStrays(job.leave_out_strays);
}
