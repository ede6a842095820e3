// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  From a scan to passes of cutter locations.
 */
#pragma once

#include "job.h"
#include "passes/pass_result.h"

#include <pcl_spiral/drive/drive_settings.h>

/** The result of a run. */
struct Result : PassResult {
  pcl_spiral::DriveReport drive;
};

/** Reads the scan or the mesh, makes the drive path, finds the cutter locations. \throw UsageError, pcl_spiral::FileError, Cancelled */
Result plan(const Job& job);
