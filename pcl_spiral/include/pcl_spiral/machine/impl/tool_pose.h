// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Position of the tool: tip and axis.
 */
#pragma once

#include <Eigen/Core>

#include <vector>

namespace pcl_spiral {

/** One location of a cutter in the workpiece frame, mm. */
struct ToolPose {
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ(); ///< unit, from the tip to the shank
  Eigen::Vector3d contact = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ(); ///< unit, out of the material at the contact
};

using ToolPoses = std::vector<ToolPose>;

/** The unit vector at share \p t of the arc from \p a to \p b, both unit; for opposite vectors, which have no arc: \p a. */
Eigen::Vector3d arcBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double t);

/** The pose at share \p t of the straight move from \p a to \p b; axis and normal move along their arcs. */
ToolPose between(const ToolPose& a, const ToolPose& b, double t);

/** Angle between two unit vectors, radians; accurate for small angles. */
double angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

} // namespace pcl_spiral
