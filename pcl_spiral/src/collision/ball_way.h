// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Whether the cutter of a path enters places that are not to be cut.
 */
#pragma once

#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/core/prism.h>
#include <pcl_spiral/core/tool_holder.h>

#include <pcl/point_types.h>

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace pcl_spiral {

constexpr double reach_radii = shank_radii + 2.0; ///< no place of a ball and its shank is farther from the contact

/** Where the ball is deepest in something. */
struct BallEntry {
  double depth = 0.0;    ///< mm
  Eigen::Vector3d place; ///< of the contact for a prism; of the point for points
};

/** Centres of the ball of radius \p radius along \p path, at its points; lifts are between pass ends. */
std::vector<Eigen::Vector3d> ballCentres(const pcl::PointCloud<ToolpathPoint>& path, double radius);

/** How deep a ball about \p centres, one for each point of \p path, enters \p prisms on its moves; absent if it does not. Lifts are not
 *  looked at. */
std::optional<BallEntry> deepestEntry(const pcl::PointCloud<ToolpathPoint>& path, const std::vector<Eigen::Vector3d>& centres,
                                      double radius, const std::vector<Prism>& prisms);

/** How deep each of \p points is in the ball or its shank on their moves along \p path, mm; 0 outside. The scanner sees the top of a
 *  clamp and not its walls: the shank meets the top. Lifts are not looked at. */
std::vector<double> depthsInWay(const pcl::PointCloud<ToolpathPoint>& path, double radius, const std::vector<Eigen::Vector3f>& points);

/** The deepest of depthsInWay; absent if no point is in the way. */
std::optional<BallEntry> deepestPoint(const pcl::PointCloud<ToolpathPoint>& path, double radius,
                                      const std::vector<Eigen::Vector3f>& points);

/** The deepest of \p points by their \p depths, mm; absent if none is deeper than 0. */
std::optional<BallEntry> deepestOf(const std::vector<Eigen::Vector3f>& points, const std::vector<double>& depths);

} // namespace pcl_spiral
