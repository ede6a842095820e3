// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The scene for pictures of pcl_spiral_drive.
 */
#pragma once

#include "planning.h"

#include <pcl_spiral/visualization/pass_picture.h>

/** \p path: all passes in sequence; the turn is the number of the pass. In the picture the turns of a helix count too. */
pcl_spiral::PassScene passScene(const Job& job, const Result& result, const std::string& title,
                                pcl::PointCloud<pcl_spiral::ToolpathPoint> path);
