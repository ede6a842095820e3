// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The cylinder that drives a cutter round a column.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/graph/impl/surface_graph.h>

#include <Eigen/Core>

#include <optional>

namespace pcl_spiral {

/** A part of an axis. Lengths in mm. If first = last, the default, it is as long as the scan. */
struct DriveCylinder {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();     ///< any point of the axis
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ(); ///< of travel from one end to the other; any length except 0
  double first = 0.0;                                   ///< where the surface begins along the axis, from the origin
  double last = 0.0;                                    ///< where it ends
};

/** How a scan lies about an axis. Lengths in mm. */
struct DriveColumn {
  DriveCylinder cylinder;   ///< the direction is unit
  bool fitted = false;      ///< to the scan; false: given
  double normal_miss = 0.0; ///< rms distance between the normals and the axis: the residual of the fit; 0 if the axis was given
  double radius = 0.0;      ///< mean by area
  double least_radius = 0.0, largest_radius = 0.0;
  double covered_angle = 360.0; ///< degrees about the axis in which there are points
  double first_angle = 0.0;     ///< degrees: where these points begin, from referenceAcross(direction), right-handed
};

/** The direction from which angles about \p axis (unit) count: X, or Y if the
 *  axis is within 26 degrees of X, made perpendicular to the axis; unit. */
Eigen::Vector3d referenceAcross(const Eigen::Vector3d& axis);

/** A place about a column's axis; \p angle in radians. */
Eigen::Vector3d placeAbout(const DriveCylinder& cylinder, double radius, double angle, double along);

/** Checks a cylinder; ok if nothing is wrong. */
Status checkCylinder(const DriveCylinder& cylinder);

/** The scan about the axis \p given, from end to end of the scan. If none is
 *  given: about the axis that its normals pass closest to, see fitRevolutionAxis.
 *
 *  Refuses a scan that is not shaped like a column: its normals are mostly along
 *  the axis (plates, domes), a fifth of it faces along the axis (end faces), its
 *  normals run round the axis (a screw, a box), or any axis would do (a sphere). */
Status findColumn(const SurfaceGraph& graph, const std::optional<DriveCylinder>& given, DriveColumn& column);

} // namespace pcl_spiral
