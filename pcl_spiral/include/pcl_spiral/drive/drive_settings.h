// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Settings of a drive path, and its report.
 */
#pragma once

#include <pcl_spiral/common/drive_pass.h>
#include <pcl_spiral/common/status.h>
#include <pcl_spiral/core/cutter_profile.h>
#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/core/setting.h>

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

namespace pcl_spiral {

/** Where a drive path runs. */
enum class DriveKind {
  Planes,        ///< sections of the surface with parallel planes along the tool axis
  Helix,         ///< one pass round a column from end to end, with a ring at both ends
  Rings,         ///< rings round a column; arcs in zigzag if the scan covers only a sector
  Curve,         ///< the user's own curve
  BoundaryOffset ///< lines at equal distances along the surface from its outer boundary, inwards
};

/** Where tool axes come from. */
enum class DriveAxisMode {
  Fixed,      ///< one axis: three-axis
  Cylinder,   ///< straight out from the axis of the drive cylinder
  LocalPlane, ///< normal of the plane through the points next to the drive point, as published: it jumps
  Surface     ///< normal of the fitted surface
};

/** A part of an axis. Lengths in mm. If first = last, the default, it is as long as the scan. */
struct DriveCylinder {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();     ///< any point of the axis
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ(); ///< of travel from one end to the other; any length except 0
  double first = 0.0;                                   ///< where the surface begins along the axis, from the origin
  double last = 0.0;                                    ///< where it ends
};

/** Settings of a drive path. Lengths in mm. */
struct DriveSettings {
  DriveKind kind = DriveKind::Planes; ///< where the path runs
  double step_over = 0.0;             ///< largest distance between neighbouring planes, rings, turns or offsets; must be set for most kinds
  double point_spacing = 1.0;         ///< largest distance between consecutive points along a pass
  double chord_error = 0.005;         ///< for sections of a mesh: straight moves stay this near the curved surface
  double plane_angle = 0.0;           ///< degrees about the axis
  Eigen::Vector3d plane_direction = Eigen::Vector3d::Zero(); ///< along the passes; zero: plane_angle is used
  DriveRows rows = DriveRows::Even;                          ///< how planes are spaced
  std::optional<CutterShape> cutter;                         ///< that follows the passes; must be set for DriveRows::Kept
  double scallop_height = 0.0;                               ///< for DriveRows::Kept
  bool zigzag = true;                                        ///< every second pass runs backwards
  bool link_rows = false;                                    ///< join rows on the surface
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();           ///< of the tool, from the tip to the shank
  std::optional<DriveCylinder> cylinder;                     ///< of helix and rings; none: fitted to the scan
  double overrun = 0.0;                                      ///< of helix and rings, beyond both ends of the column
  std::optional<DriveAxisMode> axis_mode;                    ///< none: Cylinder for helix and rings, Fixed for the others
  Polyline curve;                                            ///< of DriveKind::Curve
  bool curve_closed = false;                                 ///< the last point of the curve joins the first

  bool goesRound() const { return kind == DriveKind::Helix || kind == DriveKind::Rings; } ///< Whether the path runs round a column.
  /** The mode asked for, or the default of the kind. */
  DriveAxisMode axisMode() const { return axis_mode.value_or(goesRound() ? DriveAxisMode::Cylinder : DriveAxisMode::Fixed); }
  /** A curve with a fixed axis is used as it is. */
  bool needsSurface() const { return kind != DriveKind::Curve || axisMode() != DriveAxisMode::Fixed; }
};

/** All that have one value: without cutter, cylinder, curve and the direction as a vector. */
std::vector<Setting> settingTable(DriveSettings& settings);

/** Checks the settings; ok if nothing is wrong. */
Status checkSettings(const DriveSettings& settings);

/** How a scan lies about an axis. Lengths in mm. */
struct DriveColumn {
  DriveCylinder cylinder;       ///< the direction is unit
  bool fitted = false;          ///< to the scan; false: given
  double normal_miss = 0.0;     ///< rms distance between the normals and the axis: the residual of the fit; 0 if the axis was given
  double radius = 0.0;          ///< mean by area
  double least_radius = 0.0;    ///< of a point
  double largest_radius = 0.0;  ///< of a point
  double covered_angle = 360.0; ///< degrees about the axis in which there are points
  double first_angle = 0.0;     ///< degrees: where these points begin, from referenceAcross(direction), right-handed
};

/** Report of a drive path. */
struct DriveReport {
  std::size_t points = 0;      ///< of all passes
  double length = 0.0;         ///< of all passes, straight from point to point, mm
  double step_over = 0.0;      ///< used: the one asked for, reduced so that the surface divides
                               ///< into equal steps, mm; with DriveRows::Kept the largest
  std::size_t rows = 0;        ///< section planes
  double smallest_step = 0.0;  ///< between neighbouring planes, mm
  double held_share = 0.0;     ///< share of the surface that would need rows closer than DriveRows::Kept puts them, see DrivePath::setRows
  std::size_t facing_away = 0; ///< contacts on a mesh left out: they face away from a fixed tool axis
  std::size_t links = 0;       ///< rows joined on the surface
  std::size_t rows_apart = 0;  ///< passes of rows that could not be joined to the row before
  std::optional<DriveColumn> column;    ///< if a cylinder gave the path or the axes
  double largest_axis_step = 0.0;       ///< between consecutive points of a pass, degrees
  std::size_t axes_from_neighbours = 0; ///< points without a normal of their own: interpolated between those before and after
  std::size_t short_pieces = 0;         ///< left out: sections or lines shorter than the spacing of the scan, at its rim
  std::size_t outlier_points = 0;       ///< outliers of the scan, left out: off the surface
  Diagnostics warnings;                 ///< in full sentences, with the remedy
};

} // namespace pcl_spiral
