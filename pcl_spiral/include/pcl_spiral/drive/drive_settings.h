/** \file
 *  What a drive path is asked for, and what came of it.
 */
#pragma once

#include <pcl_spiral/common/impl/drive_rows.h>
#include <pcl_spiral/core/impl/polyline.h>
#include <pcl_spiral/drive/impl/drive_cylinder.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace pcl_spiral {

/** Where a drive path runs. */
enum class DriveKind {
  Planes,        ///< sections of the surface with parallel planes along the tool axis
  Helix,         ///< one pass round a column from end to end, closed by a ring at both
  Rings,         ///< rings round a column; arcs, to and fro, where the scan covers a sector only
  Curve,         ///< the user's own curve
  BoundaryOffset ///< lines at equal distances along the surface from its outer boundary, inwards
};

/** Where tool axes come from. */
enum class DriveAxisMode {
  Fixed,      ///< one axis: three-axis
  Cylinder,   ///< straight out of the axis of the drive cylinder
  LocalPlane, ///< normal of the plane through the points next to the drive point, as published: it jumps
  Surface     ///< normal of the fitted surface
};

/** Lengths in mm. */
struct DriveSettings {
  DriveKind kind = DriveKind::Planes;
  double step_over = 0.0;
  double point_spacing = 1.0;
  double chord_error = 0.005; ///< of sections of a mesh: straight moves stay this near the curved surface
  double plane_angle = 0.0;                                  ///< degrees about the axis
  Eigen::Vector3d plane_direction = Eigen::Vector3d::Zero(); ///< along the passes; zero: plane_angle tells
  DriveRows rows = DriveRows::Even;
  double tool_radius = 0.0, scallop_height = 0.0; ///< of the ball that rows are kept for, and its ridges
  bool zigzag = true;
  bool link_rows = false;
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  std::optional<DriveCylinder> cylinder;
  double overrun = 0.0; ///< of helix and rings, beyond both ends of the column
  std::optional<DriveAxisMode> axis_mode; ///< none: Cylinder for helix and rings, Fixed for the others
  Polyline curve;
  bool curve_closed = false;

  bool
  goesRound() const
  {
    return kind == DriveKind::Helix || kind == DriveKind::Rings;
  }
  DriveAxisMode
  axisMode() const
  {
    return axis_mode.value_or(goesRound() ? DriveAxisMode::Cylinder : DriveAxisMode::Fixed);
  }
  /** A curve whose axis is fixed is taken as it is. */
  bool
  needsSurface() const
  {
    return kind != DriveKind::Curve || axisMode() != DriveAxisMode::Fixed;
  }
};

/** What is wrong with settings; ok where nothing is. */
Status checkSettings(const DriveSettings& settings);

/** What came of a drive path. */
struct DriveReport {
  std::size_t points = 0;
  double length = 0.0; ///< of all passes, straight from point to point, mm
  double step_over =
      0.0; ///< taken: the one asked for, made smaller so that the surface divides into equal steps, mm; of kept rows the
           ///< largest
  std::size_t rows = 0;       ///< section planes
  double smallest_step = 0.0; ///< of neighbouring planes, mm
  double held_share = 0.0;    ///< of the surface: asks for kept rows closer than these are put, see DrivePath::setRows
  std::size_t facing_away = 0; ///< contacts on a mesh left out: they face away from a fixed tool axis
  std::size_t links = 0;      ///< of rows, joined on the surface
  std::size_t rows_apart = 0; ///< passes of rows that could not be joined to the one before
  std::optional<DriveColumn> column; ///< where a cylinder drove path or axes
  double largest_axis_step = 0.0;    ///< between consecutive points of a pass, degrees
  std::size_t axes_from_neighbours =
      0; ///< points with no normal of their own: between those before and after
  std::size_t short_pieces =
      0; ///< left out: sections or lines shorter than the spacing of the scan, at its edges
  std::size_t stray_points = 0; ///< of the scan, left out: off the surface
  std::vector<std::string> warnings;
};

} // namespace pcl_spiral
