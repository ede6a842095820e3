// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  From a scan to located passes.
 */
#pragma once

#include "job.h"
#include "passes/pass_result.h"

#include <pcl_spiral/drive/drive_settings.h>

/** All that a run came to. */
struct Result : PassResult {
  pcl_spiral::DriveReport drive;
};

/** Reads the scan or the mesh, makes the drive path, locates the cutter. \throw UsageError, pcl_spiral::FileError, Cancelled */
Result plan(const Job& job);
