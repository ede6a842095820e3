// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The user's settings for one run of pcl_spiral_view.
 */
#pragma once

#include "judging/judge_options.h"
#include <pcl_spiral/planning/impl/path_judging.h>

#include <pcl_spiral/io/cloud_reader.h>

#include <ostream>
#include <string>

/** The user's settings for one run. */
struct ViewJob {
  std::string scan, path; ///< path empty: the scan alone
  pcl_spiral::ReadOptions read;
  std::optional<MeshChoice> mesh;     ///< absent: the first file is a scan
  PartOptions part;                   ///< of the scan
  RegionChoice regions;               ///< at most one
  pcl_spiral::JudgeSettings settings; ///< cutter with radius 0: not given
  bool quiet = false;
  bool help = false;
  bool version = false;
};

/** \throw UsageError */
ViewJob parseViewCommandLine(int argc, const char* const* argv);

void printViewHelp(std::ostream& out);
