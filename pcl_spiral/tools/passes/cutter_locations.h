// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Gouge-free cutter locations along drive passes.
 */
#pragma once

#include "pass_job.h"
#include "pass_result.h"
#include "terminal/terminal.h"

#include <pcl_spiral/common/drive_pass.h>
#include <pcl_spiral/cutter/tool_location.h>
#include <pcl_spiral/surface/surface.h>

#include <vector>

/** Locations on the part of \p result: its mesh, or its scan with the surface. Sets the figures of \p result. \throw UsageError,
 *  pcl_spiral::FileError, Cancelled */
std::vector<pcl_spiral::ToolLocations> locateCutter(const PassJob& job, const pcl_spiral::Surface::ConstPtr& surface,
                                                    const pcl_spiral::DrivePasses& passes, ProgressBar& bar, PassResult& result);

/** \throw pcl_spiral::FileError if shank or holder would collide with the part and that is not accepted */
void requireNoCollision(const PassJob& job, const std::vector<pcl_spiral::ToolLocations>& located);

/** \throw pcl_spiral::FileError if more of the scan is above the end of a tool that is not known to end there: the axis is fixed, or
 *  there is no holder */
void requireKnownEnd(const PassJob& job, const std::vector<pcl_spiral::ToolLocations>& located);

/** Puts the passes into \p result without the locations off the part; a pass is cut in two there. */
void takePoses(const std::vector<pcl_spiral::ToolLocations>& located, PassResult& result);

/** Adds the warnings about the locations. */
void warnOfLocations(const PassJob& job, PassResult& result);
