// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The scan or mesh that paths are judged by.
 */
#pragma once

#include "judge_options.h"

#include <pcl_spiral/planning/impl/path_judge.h>

/** What paths are judged by, as the files say. */
struct JudgedScan {
  pcl_spiral::JudgedInput input;
  ScanSide side;                    ///< of a scan
  pcl_spiral::Diagnostics warnings; ///< from reading
};

/** Reads the first of the files, the scan or the mesh, and sets the shift of the run. \throw pcl_spiral::FileError, UsageError */
JudgedScan readJudged(const JudgeOptions& options);
