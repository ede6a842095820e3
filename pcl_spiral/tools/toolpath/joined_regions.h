// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Several regions as one run.
 */
#pragma once

#include "outputs.h"

#include <pcl_spiral/common/impl/stage_clock.h>

#include <vector>

/** One path with all passes of \p regions, in their order, the tool lifted between them; points and reports together. \p input is the
 *  scan or the mesh that all were chosen from. \throw
 *  pcl_spiral::FileError if regions have points in common, or if the tool would touch the scan between them */
Result joined(const Job& job, const Result& input, std::vector<Result> regions);

/** Adds the time of \p stage to the stage of its name in \p stages, or puts it first. */
void addStage(const pcl_spiral::StageCost& stage, std::vector<pcl_spiral::StageCost>& stages);
