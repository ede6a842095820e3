// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Both ends of a path enlarged.
 */
#pragma once

#include "canvas.h"

#include <pcl_spiral/common/point_types.h>

#include <pcl/point_cloud.h>

#include <string>

namespace pcl_spiral {

/** Start and end of the path, each looking along its normal, sixteen times \p pitch across, with everything of the path
 *  there; \p turn: what the words call a part of it, "turn" or "pass". */
void addEndViews(Canvas& canvas, const pcl::PointCloud<ToolpathPoint>& path, double pitch, const std::string& turn,
                 vtkScalarsToColors* colors);

} // namespace pcl_spiral
