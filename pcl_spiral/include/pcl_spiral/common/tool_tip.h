// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The tip of a ball cutter at a point of a toolpath.
 */
#pragma once

#include <pcl_spiral/common/point_types.h>

namespace pcl_spiral {

/** Tip of a ball cutter that touches at \p point: contact + radius (normal - axis), mm. */
inline Eigen::Vector3d
toolTip(const ToolpathPoint& point, double tool_radius)
{
  const Eigen::Vector3d normal = point.getNormalVector3fMap().cast<double>();
  const Eigen::Vector3d axis = point.getAxisVector3fMap().cast<double>();
  return point.getVector3fMap().cast<double>() + tool_radius * (normal - axis);
}

} // namespace pcl_spiral
