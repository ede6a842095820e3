// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What stands beside the part in the way of ball and shank, with its extent.
 */
#pragma once

#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/core/diagnostic.h>

#include <pcl/point_cloud.h>

#include <Eigen/Geometry>

#include <vector>

namespace pcl_spiral {

/** Something that ball or shank would cut into. */
struct ThingInTheWay {
  double depth = 0.0;                              ///< of its deepest point, mm
  Eigen::Vector3d place = Eigen::Vector3d::Zero(); ///< of that point
  Eigen::AlignedBox3d box; ///< of its points that are no lower than those that would be cut, a third of a link wider
  bool around = false;     ///< it surrounds the path, or lies over it
};

/** The things among \p points that the ball or its shank cuts into by more than \p allowed, mm, on its moves along \p path, the deepest
 *  first. Steps of \p link join the points of a thing. What is lower than all that would be cut, as the table below a clamp, is no part
 *  of it. Where a thing surrounds the path, or lies over it, its box has only the points that would be cut. */
std::vector<ThingInTheWay> thingsInTheWay(const pcl::PointCloud<ToolpathPoint>& path, double radius,
                                          const std::vector<Eigen::Vector3f>& points, double allowed, double link);

/** "1 thing stands in the way: from (0, 0, 0) to (10, 12, 8), 10 by 12 mm"; the deepest few, and how many more.
 *  \p to_keep_out: each box is proposed as a keep-out. */
Diagnostic thingsText(const std::vector<ThingInTheWay>& things, bool to_keep_out);

} // namespace pcl_spiral
