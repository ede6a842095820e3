// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Places and axes along which a cutter is driven over a scan or a mesh.
 */
#pragma once

#include <pcl_spiral/common/drive_pass.h>
#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/common/status.h>
#include <pcl_spiral/drive/drive_settings.h>
#include <pcl_spiral/mesh/impl/mesh_input.h>
#include <pcl_spiral/mesh/surface_mesh.h>

#include <pcl/PolygonMesh.h>
#include <pcl/pcl_base.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

namespace pcl_spiral {

/** Drive points in passes over a scan, with tool axes and without normals. Each is a
 *  line along which CutterLocation moves the cutter down until it touches. The spiral
 *  of SpiralToolpathGenerator is another such path: see CutterLocation::setDrivePath.
 *
 *  - DriveKind::Planes: planes that contain the tool axis and the direction of the
 *  passes cut the triangulated scan. The extent across is divided into equal steps no
 *  larger than the step-over, with a plane in the middle of each. Gaps wider than three
 *  spacings of the scan cut a pass in two. Where one part hides another from the tool,
 *  both are cut: CutterLocation then lifts the cutter from the lower onto the upper.
 *  - DriveKind::Helix, Rings: on a cylinder with the scan's mean radius about the axis of the drive
 *  cylinder, which is given or fitted. The extent along the axis is divided in the same way. The helix
 *  climbs one step per turn from the middle of the first step to that of the last, with a ring at both ends.
 *  - DriveKind::Curve: a curve at equal steps of arc length.
 *  - DriveKind::BoundaryOffset: lines at equal distances from the outer boundary, measured
 *  along the surface. The greatest distance is divided in the same way. The outermost
 *  line is first; the boundary is on the right. Where an island ends more than half
 *  a step inside its last line, one more line runs half a step from its peak. A hole
 *  cuts the lines. A rim more jagged than half a step also cuts them, with a warning.
 *
 *  No place of the surface is farther from a pass than half a step-over, across the passes: projected
 *  along the tool axis for planes, along the axis of the cylinder, or along the surface for offsets.
 *
 *  Takes a cloud or a surface, see SurfaceInput; a curve with a fixed axis needs neither. Source of planes
 *  and cylinder: Sun, Cui, Kang, Wang, five-axis NC toolpath generation from scattered points. Lengths in
 *  mm, angles in degrees. The output does not depend on the order of the cloud or on the number of threads. */
template <typename PointT>
class DrivePath : public MeshInput<PointT> {
public:
  DrivePath() { this->surfaceSettings().strict = false; } // a rough surface is accepted, with a warning

  /** Drives over a mesh. A SurfaceMesh is made of it with default settings. The last input set counts:
   *  cloud, surface or mesh. Planes give the sections of the mesh (MeshSections): contacts with normals, on
   *  the curved surface behind the faces; AxisMode::Fixed leaves out what faces away from the axis. Helix,
   *  rings and curves are as on a cloud, made of points of the mesh (MeshSampling). Kind::BoundaryOffset is
   *  refused. Settings for clouds (normals, view point, thinning and so on) must be at their defaults. */
  using MeshInput<PointT>::setInputMesh;
  /** The mesh given, or made by the last compute from the polygons given; null before, and for clouds. */
  SurfaceMesh::ConstPtr getInputMesh() const { return this->mesh_; }

  using Ptr = pcl::shared_ptr<DrivePath>;            ///< A shared pointer.
  using ConstPtr = pcl::shared_ptr<const DrivePath>; ///< A shared pointer to a constant one.
  using Kind = DriveKind;                            ///< Where the path runs.
  using AxisMode = DriveAxisMode;                    ///< Where tool axes come from.
  using Rows = DriveRows;                            ///< How planes are spaced.

  /** Where the path runs; Kind::Planes by default. */
  void setKind(DriveKind kind) { settings_.kind = kind; }
  DriveKind getKind() const { return settings_.kind; } ///< The value of setKind.

  /** Largest distance between neighbouring planes, rings, turns or offsets, mm. Must be set, except for a curve
   *  and for DriveRows::Kept, where it has no effect. To get it from the cutter's profile: stepForScallop. */
  void setStepOver(double step) { settings_.step_over = step; }
  double getStepOver() const { return settings_.step_over; } ///< The value of setStepOver.

  /** Largest distance between consecutive drive points along their pass, mm; 1 by default. */
  void setPointSpacing(double spacing) { settings_.point_spacing = spacing; }
  double getPointSpacing() const { return settings_.point_spacing; } ///< The value of setPointSpacing.

  /** For sections of a mesh: straight moves stay this near the curved surface, mm; 0.005 by default. */
  void setChordError(double error) { settings_.chord_error = error; }
  double getChordError() const { return settings_.chord_error; } ///< The value of setChordError.

  /** Direction of the passes of planes: degrees about the tool axis, right-handed,
   *  from X, or from Y if the axis is within 26 degrees of X. 0 by default. */
  void setPlaneDirection(double degrees)
  {
    settings_.plane_angle = degrees;
    settings_.plane_direction.setZero();
  }
  double getPlaneAngle() const { return settings_.plane_angle; } ///< The angle of setPlaneDirection, degrees.
  /** The same as a vector; its part along the tool axis has no effect. */
  void setPlaneDirection(const Eigen::Vector3d& along) { settings_.plane_direction = along; }
  /** Zero if the angle is used instead. */
  const Eigen::Vector3d& getPlaneDirection() const { return settings_.plane_direction; }

  /** How planes are spaced; DriveRows::Even by default. DriveRows::Kept, for Kind::Planes: as few planes as possible, so
   *  that the cutter of setScallop leaves no ridge above the scallop height between two planes, from slope and curvature
   *  of the fitted surface. Steps never go below a quarter of the step of a ball with the cutter's corner radius r on a plane,
   *  2 sqrt((2 r - h) h), or of h if the corner is sharp; a warning reports where less would be needed, as on walls along the
   *  planes. \see rowDistance, profileRowDistance, rowLevels */
  void setRows(DriveRows rows) { settings_.rows = rows; }
  DriveRows getRows() const { return settings_.rows; } ///< The value of setRows.
  /** The cutter that follows the passes. With it, planes and their passes over a scan with AxisMode::Fixed go on beyond a rim that
   *  falls away, until the cutter touches the surface at the rim. Without it, contacts end inside such a rim, a ball's by R sin(slope). */
  void setCutter(const CutterShape& cutter) { settings_.cutter = cutter; }
  const std::optional<CutterShape>& getCutter() const { return settings_.cutter; } ///< The value of setCutter or setScallop.
  /** Cutter, see setCutter, and scallop \p height for DriveRows::Kept, mm. Must be set for it. On a mesh only a ball keeps rows. */
  void setScallop(const CutterShape& cutter, double height)
  {
    settings_.cutter = cutter;
    settings_.scallop_height = height;
  }
  /** The same for a ball of \p radius, mm. */
  void setScallop(double radius, double height) { setScallop(CutterShape::ball(radius), height); }
  double getToolRadius() const { return settings_.cutter ? settings_.cutter->radius : 0.0; } ///< The cutter's radius, mm; 0 without one.
  double getScallopHeight() const { return settings_.scallop_height; }                       ///< The height of setScallop, mm.

  /** Whether rows of planes in zigzag are joined on the surface to one pass. This is done if the next row begins within two
   *  step-overs of the end of this row, and the straight way between is over the scan and crosses no gap. False by default. */
  void setLinkRows(bool link) { settings_.link_rows = link; }
  bool getLinkRows() const { return settings_.link_rows; } ///< The value of setLinkRows.

  /** Whether every second plane, or arc of a sector, runs backwards; true by default. */
  void setZigzag(bool zigzag) { settings_.zigzag = zigzag; }
  bool getZigzag() const { return settings_.zigzag; } ///< The value of setZigzag.

  /** Tool axis, from the tip to the shank: for AxisMode::Fixed, and for section planes. +Z by default. */
  void setAxis(const Eigen::Vector3d& axis) { settings_.axis = axis; }
  const Eigen::Vector3d& getAxis() const { return settings_.axis; } ///< The value of setAxis.

  /** Axis and extent for helix, rings and AxisMode::Cylinder. If not set, it is fitted
   *  to the scan, which must be a column scanned from outside. \see findColumn */
  void setCylinder(const DriveCylinder& cylinder) { settings_.cylinder = cylinder; }
  const std::optional<DriveCylinder>& getCylinder() const { return settings_.cylinder; } ///< The value of setCylinder.

  /** How far helix and rings continue beyond both ends of the column, mm; 0 by default. Where
   *  the surface leans along the column, a cutter of radius R touches it up to R sin(lean)
   *  away from its own axis. Without overrun, that much of an end is not reached. */
  void setOverrun(double overrun) { settings_.overrun = overrun; }
  double getOverrun() const { return settings_.overrun; } ///< The value of setOverrun.

  /** AxisMode::Cylinder by default for helix and rings, AxisMode::Fixed for the others. */
  void setAxisMode(DriveAxisMode mode) { settings_.axis_mode = mode; }
  DriveAxisMode getAxisMode() const { return settings_.axisMode(); } ///< The value of setAxisMode.

  /** The curve of Kind::Curve; a closed one does not repeat its first point.
   *  Points are put along it at equal steps of arc length, and cut its corners. */
  void setCurve(const Polyline& curve, bool closed = false)
  {
    settings_.curve = curve;
    settings_.curve_closed = closed;
  }
  const Polyline& getCurve() const { return settings_.curve; } ///< The value of setCurve.

  /** Called with the completed share; return false to cancel. */
  void setProgressCallback(ProgressCallback callback) { progress_ = std::move(callback); }

  /** Computes the passes. \p passes is empty on failure: no cloud or fewer than
   *  50 points, a setting out of range, a scan of the wrong shape, a path of
   *  more than 1e8 points or larger than the free memory, or cancelled. */
  void compute(DrivePasses& passes);

  const DriveReport& getReport() const { return report_; } ///< Figures and warnings of the last compute.

private:
  Status run(DrivePasses& passes);
  Status runOnMesh(DrivePasses& passes);

  DriveSettings settings_;
  ProgressCallback progress_;
  DriveReport report_;
};

} // namespace pcl_spiral

#include <pcl_spiral/drive/impl/drive_path.hpp>

namespace pcl_spiral {
extern template class DrivePath<pcl::PointXYZ>;
extern template class DrivePath<pcl::PointXYZRGB>;
extern template class DrivePath<pcl::PointNormal>;
} // namespace pcl_spiral
