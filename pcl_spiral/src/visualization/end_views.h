// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Enlarged views of both ends of a path.
 */
#pragma once

#include "canvas.h"

#include <pcl_spiral/common/point_types.h>

#include <pcl/point_cloud.h>

#include <string>

namespace pcl_spiral {

/** Start and end of the path, each seen along its normal, sixteen times \p pitch across, with all of the path
 *  there; \p turn: the word for a part of it, "turn" or "pass". */
void addEndViews(Canvas& canvas, const pcl::PointCloud<ToolpathPoint>& path, double pitch, const std::string& turn,
                 vtkScalarsToColors* colors);

} // namespace pcl_spiral
