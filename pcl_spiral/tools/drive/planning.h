// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  From a scan to passes of cutter locations.
 */
#pragma once

#include "job.h"
#include "passes/pass_result.h"

/** The result of a run. */
using Result = PassResult;

/** Reads the scan or the mesh, makes the drive path, finds the cutter locations. \throw UsageError, pcl_spiral::FileError, Cancelled */
Result plan(const Job& job);
