/** \file
 *  The cylinder that drives a cutter round a column.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/graph/impl/surface_graph.h>

#include <Eigen/Core>

#include <optional>

namespace pcl_spiral {

/** A piece of an axis. Lengths in mm. With first = last, as by default, it is as long as the scan. */
struct DriveCylinder {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero(); ///< any point of the axis
  Eigen::Vector3d direction =
      Eigen::Vector3d::UnitZ(); ///< of travel from one end to the other; of any length but 0
  double first = 0.0;           ///< where the surface begins along the axis, from the origin
  double last = 0.0;            ///< where it ends
};

/** How a scan lies about an axis. Lengths in mm. */
struct DriveColumn {
  DriveCylinder cylinder; ///< the direction is unit
  bool fitted = false;    ///< to the scan; false: given
  double normal_miss =
      0.0; ///< rms distance at which normals pass the axis: what the fit leaves; 0 where it was given
  double radius = 0.0; ///< mean by area
  double least_radius = 0.0, largest_radius = 0.0;
  double covered_angle = 360.0; ///< degrees about the axis in which there are points
  double first_angle = 0.0;     ///< degrees, where these begin, from referenceAcross(direction), right-handed
};

/** The direction from which angles about \p axis (unit) count: X, or Y where the axis is within 26 degrees of
 * X, made perpendicular to the axis; unit. */
Eigen::Vector3d referenceAcross(const Eigen::Vector3d& axis);

/** A place about a column's axis; \p angle in radians. */
Eigen::Vector3d placeAbout(const DriveCylinder& cylinder, double radius, double angle, double along);

/** What is wrong with a cylinder; ok where nothing is. */
Status checkCylinder(const DriveCylinder& cylinder);

/** The scan about \p given, or where there is none about the axis that its normals pass closest to, see
 * fitRevolutionAxis, from end to end of the scan.
 *
 *  Refused where the scan is not shaped like a column: its normals stand mostly along the axis (plates,
 * domes), a fifth of it faces along the axis (end faces), they run round it (a screw, a box), or any axis
 * would do (a sphere). */
Status findColumn(const SurfaceGraph& graph, const std::optional<DriveCylinder>& given, DriveColumn& column);

} // namespace pcl_spiral
