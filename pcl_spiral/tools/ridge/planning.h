// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Makes rows of a tool from two measured lines or a scan.
 */
#pragma once

#include "job.h"
#include "passes/pass_result.h"

#include <pcl_spiral/planning/ridge_plan.h>

/** The result of a run. Without a cutter the mesh is of the ridge, and only for pictures. */
struct Result : PassResult, pcl_spiral::RidgePlanReport {};

/** Reads or finds the lines, makes the rows, finds the cutter locations. \throw UsageError, pcl_spiral::FileError, Cancelled */
Result plan(const Job& job);
