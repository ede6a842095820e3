// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The report of several regions together.
 */
#pragma once

#include "outputs.h"

#include <vector>

/** Sums of counts and lengths, the worst of what is measured, and all loops, lines, holes, places and warnings of \p regions, which are
 *  the passes of \p path. What only one region can have, such as the centre, is that of the first. */
pcl_spiral::SpiralReport joinedReport(const std::vector<Result>& regions, const pcl::PointCloud<pcl_spiral::ToolpathPoint>& path);
