// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The cylinder that drives a cutter round a column.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/drive/drive_settings.h>
#include <pcl_spiral/graph/impl/surface_graph.h>

#include <Eigen/Core>

#include <optional>

namespace pcl_spiral {

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
