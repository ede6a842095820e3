// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Input and settings of all classes that make drive passes.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/core/cutter_profile.h>
#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/drive/drive_settings.h>
#include <pcl_spiral/mesh/impl/mesh_input.h>

#include <Eigen/Core>

#include <optional>
#include <utility>

namespace pcl_spiral {

/** A scan or a mesh, and the settings of passes over it. Base of DrivePath and DrivePlanner. */
template <typename PointT>
class DriveInput : public MeshInput<PointT> {
public:
  DriveInput() { this->surfaceSettings().strict = false; } // a rough surface is accepted, with a warning

  /** Drives over a mesh. A SurfaceMesh is made of it with default settings. The last input set counts:
   *  cloud, surface or mesh. Planes give the sections of the mesh (MeshSections): contacts with normals, on
   *  the curved surface behind the faces; AxisMode::Fixed leaves out what faces away from the axis. Helix,
   *  rings and curves are as on a cloud, made of points of the mesh (MeshSampling). Kind::BoundaryOffset is
   *  refused. Settings for clouds (normals, view point, thinning and so on) must be at their defaults. */
  using MeshInput<PointT>::setInputMesh;
  /** The mesh given, or made by the last compute from the polygons given; null before, and for clouds. */
  SurfaceMesh::ConstPtr getInputMesh() const { return this->mesh_; }

  using Kind = DriveKind;         ///< Where the path runs.
  using AxisMode = DriveAxisMode; ///< Where tool axes come from.
  using Rows = DriveRows;         ///< How planes are spaced.

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
   *  that the cutter leaves no ridge above the scallop height between two planes, from slope and curvature
   *  of the fitted surface. Steps never go below a quarter of the step of a ball with the cutter's corner radius r on a plane,
   *  2 sqrt((2 r - h) h), or of h if the corner is sharp; a warning reports where less would be needed, as on walls along the
   *  planes. \see rowDistance, profileRowDistance, rowLevels */
  void setRows(DriveRows rows) { settings_.rows = rows; }
  DriveRows getRows() const { return settings_.rows; } ///< The value of setRows.
  /** The cutter that follows the passes. With it, planes and their passes over a scan with AxisMode::Fixed go on beyond a rim that
   *  falls away, until the cutter touches the surface at the rim. Without it, contacts end inside such a rim, a ball's by R sin(slope). */
  void setCutter(const CutterShape& cutter) { settings_.cutter = cutter; }
  const std::optional<CutterShape>& getCutter() const { return settings_.cutter; } ///< The value of setCutter or setToolRadius.
  /** The same for a ball of \p radius, mm. */
  void setToolRadius(double radius) { setCutter(CutterShape::ball(radius)); }
  /** Scallop height for DriveRows::Kept, mm. Must be set for it, as the cutter must. On a mesh only a ball keeps rows. */
  void setScallopHeight(double height) { settings_.scallop_height = height; }
  /** \deprecated Use setCutter and setScallopHeight. */
  [[deprecated("use setCutter and setScallopHeight")]] void setScallop(const CutterShape& cutter, double height)
  {
    setCutter(cutter), setScallopHeight(height);
  }
  /** \deprecated Use setToolRadius and setScallopHeight. */
  [[deprecated("use setToolRadius and setScallopHeight")]] void setScallop(double radius, double height)
  {
    setToolRadius(radius), setScallopHeight(height);
  }
  double getToolRadius() const { return settings_.cutter ? settings_.cutter->radius : 0.0; } ///< The cutter's radius, mm; 0 without one.
  double getScallopHeight() const { return settings_.scallop_height; }                       ///< The value of setScallopHeight.

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

  /** Every setting of the passes at once. */
  void setSettings(const DriveSettings& settings) { settings_ = settings; }
  const DriveSettings& getSettings() const { return settings_; } ///< The value of setSettings.

protected:
  DriveSettings settings_;    ///< of the setters
  ProgressCallback progress_; ///< of setProgressCallback
};

} // namespace pcl_spiral
