// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Five-axis cutter locations without gouge, from a cloud or a mesh.
 */
#pragma once

#include <pcl_spiral/common/drive_pass.h>
#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/common/status.h>
#include <pcl_spiral/cutter/impl/cutter_location_engine.h>
#include <pcl_spiral/cutter/impl/location_bisection.h>
#include <pcl_spiral/cutter/impl/location_mesh.h>
#include <pcl_spiral/cutter/tool_location.h>
#include <pcl_spiral/mesh/impl/mesh_input.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <memory>
#include <vector>

namespace pcl_spiral {

/** Places a cutter of any profile on a scan so that it does not cut into the scan.
 *  For each drive point it finds the highest place along the axis where the cutter
 *  touches a point within its reach, or the surface fitted to the points.
 *
 *  Takes a cloud or a surface, see SurfaceInput. The cutter stays off every finite point,
 *  also off points left out of the surface. If no surface can be made of a cloud, the
 *  points are enough (Evaluation::Points). Also takes a mesh: the cutter stays off
 *  all its faces, or off the curved surface behind them. That is exact on flat triangles;
 *  on curved ones it holds to a hundredth of the contact tolerance, and to 1e-4 mm.
 *  Source: Sun, Cui, Kang, Wang, five-axis NC toolpath generation from scattered points. Lengths
 *  in mm. The output does not depend on the order of the cloud or on the number of threads. */
template <typename PointT>
class CutterLocation : public MeshInput<PointT> {
public:
  CutterLocation() { this->surfaceSettings().strict = false; } // a rough surface is accepted
  using Ptr = pcl::shared_ptr<CutterLocation>;                 ///< A shared pointer.
  using ConstPtr = pcl::shared_ptr<const CutterLocation>;      ///< A shared pointer to a constant one.
  using Path = pcl::PointCloud<ToolpathPoint>;                 ///< A toolpath.
  using Evaluation = LocationEvaluation;                       ///< How the height of a location is found.

  /** Places, axes and, where a contact is asked for, normals. */
  void setDrivePoints(DrivePoints points)
  {
    drive_points_ = std::move(points);
    pass_sizes_ = {drive_points_.size()};
  }
  /** The same with several passes, such as those of DrivePath; the first point of a ring is repeated at its end. */
  void setDrivePasses(const DrivePasses& passes);
  const DrivePoints& getDrivePoints() const { return drive_points_; } ///< The value of setDrivePoints.
  /** The same from a toolpath: its contacts, axes and normals (zero: none). */
  void setDrivePath(const Path& path);

  /** Shape of the cutter. Must be set. */
  void setCutter(const CutterShape& cutter) { cutter_ = cutter; }
  const CutterShape& getCutter() const { return cutter_; } ///< The value of setCutter.

  /** How the height of a location is found; Evaluation::FittedSurface by default. */
  void setEvaluation(Evaluation evaluation) { options_.evaluation = evaluation; }
  Evaluation getEvaluation() const { return options_.evaluation; } ///< The value of setEvaluation.

  /** A contact counts as reached if the cutter touches within this distance along the axis, mm; 0.01 by default. */
  void setContactTolerance(double tolerance) { options_.tolerance = tolerance; }
  double getContactTolerance() const { return options_.tolerance; } ///< The value of setContactTolerance.

  /** The parts above the cutter, from the top of its flank upwards: shank, extensions,
   *  chuck. None by default: no collision check. Set the cutter's flank length too. */
  void setHolder(std::vector<ToolSegment> segments) { options_.holder = std::move(segments); }
  const std::vector<ToolSegment>& getHolder() const { return options_.holder; } ///< The value of setHolder.

  /** Distance to keep between holder and scan, mm; 0 by default. Less counts as a collision. */
  void setHolderClearance(double clearance) { options_.holder_clearance = clearance; }
  double getHolderClearance() const { return options_.holder_clearance; } ///< The value of setHolderClearance.

  /** From how far above the drive point, along the axis, the cutter comes down, mm: what is higher does not hold it up, such as the
   *  opposite wall of a bore, or a roof. Measured from the tip where the cutter touches at the contact asked for, or from the drive
   *  point. Must not be below the top of the flank. Infinite: from above everything. 0, the default: the length of cutter and holder.
   *  Without a holder it is ten radii above the centre of the ball (of the corner), or infinite if all axes are the same: such a tool
   *  comes from above everything.
   *
   *  What is above the ceiling and in the cutter, or in a shank as wide if there is no holder, is reported as a collision, as for the
   *  holder. If more of the scan is above the end of the tool, ToolLocation::under_scan is set. */
  void setCeiling(double ceiling) { ceiling_ = ceiling; }
  double getCeiling() const { return ceiling_; } ///< The value of setCeiling.

  /** Largest angle by which the axis may turn where the contact asked for is not reached or the holder
   *  collides, degrees, up to 90. 0, the default: the cutter is lifted instead. The smallest of six
   *  angles that helps is taken. Each point is treated separately, unless setRetiltStep is called: neighbouring axes may differ by as
   *  much as this angle. Drive points must then ask for contacts: refused if none of them has a normal. */
  void setMaxRetilt(double degrees) { options_.max_retilt = degrees; }
  double getMaxRetilt() const { return options_.max_retilt; } ///< The value of setMaxRetilt.

  /** Largest change of that turn from one drive point of a pass to the next, degrees: between them the axis turns by no more than
   *  this and the turn of the axes asked for. The turn then begins before the place that needs it and ends after it. Where no
   *  contact is asked for, axes turn about the contact that the cutter touches, where the holder collides. 0, the default: no limit, each
   *  point is treated separately, which suits single points. */
  void setRetiltStep(double degrees) { options_.retilt_step = degrees; }
  double getRetiltStep() const { return options_.retilt_step; } ///< The value of setRetiltStep.

  /** Adds locations between the drive points until no straight move of the cutter cuts deeper into the
   *  surface than this, mm, or leaves more than this. 0, the default: none. \see bisectLocations */
  void setPathTolerance(double tolerance) { path_tolerance_ = tolerance; }
  double getPathTolerance() const { return path_tolerance_; } ///< The value of setPathTolerance.

  /** Called with the completed share; return false to cancel. */
  void setProgressCallback(ProgressCallback callback) { progress_ = std::move(callback); }

  /** Reuses what the last compute of an object made of the same cloud or surface: obstacles, fit and rim are not made
   *  again. Null, the default: made at every compute. setInputCloud, setInputSurface and setInputMesh clear it. */
  void setLocationSurface(const std::shared_ptr<const LocationSurface>& surface) { given_location_ = surface; }
  /** The surface used by the last compute; null before, and on a mesh. */
  std::shared_ptr<const LocationSurface> getLocationSurface() const { return location_surface_; }
  /** Locates on a mesh. A SurfaceMesh is made of it with default settings. The last input set counts: cloud,
   *  surface or mesh. Settings for clouds (normals, view point, indices, thinning and so on) must be at their
   *  defaults. Evaluation::FittedSurface uses the curved surface behind the faces: lower than the faces in
   *  hollows and higher on ridges, by the sag of the facets. Evaluation::Points uses the faces as they are.
   *  Cutters stay off both sides of a face. The first compute prepares the mesh and keeps it for further ones. */
  using MeshInput<PointT>::setInputMesh;
  /** The mesh given, or made by the last compute from the polygons given; null before, and for clouds. */
  SurfaceMesh::ConstPtr getInputMesh() const { return this->mesh_; }
  /** Computes the locations. \p locations has one per drive point, in their order; a path tolerance adds more between
   *  them. cloud_index is the index in the input cloud, or of the face of getInputMesh. Empty on failure: no cloud, no
   *  finite point, no drive point, a drive point that is not finite or has no axis, a setting out of range, no surface
   *  in the points (unless Evaluation::Points), no mesh, a mesh that SurfaceMesh::make refuses, or cancelled. */
  void compute(ToolLocations& locations);
  /** The same by passes. */
  void compute(std::vector<ToolLocations>& passes);

  /** Counts, largest values and warnings of the last compute. */
  const LocationReport& getReport() const { return figures_; }
  [[deprecated("use getReport")]] const LocationReport& getFigures() const { return getReport(); } ///< \deprecated Use getReport.
  /** Figures of the path tolerance: locations added, largest error. */
  const BisectionReport& getBisectionReport() const { return bisection_figures_; }
  [[deprecated("use getBisectionReport")]] const BisectionReport& getBisectionFigures() const
  {
    return getBisectionReport();
  } ///< \deprecated Use getBisectionReport.

private:
  Status check() const;
  LocationOptions optionsWithCeiling() const;
  Status makeLocationSurface();
  Status makeLocationMesh();
  Status checkBesideMesh() const;
  Status run(std::vector<ToolLocations>& passes);
  Status locate(const CutterLocationEngine& locator, std::vector<ToolLocations>& passes);
  Status retilt(const CutterLocationEngine& locator, double margin, std::vector<ToolLocations>& passes) const;
  Status bisect(const CutterLocationEngine& locator, std::vector<ToolLocations>& passes, BisectionReport& figures) const;
  std::vector<ToolLocations> inPasses(const ToolLocations& locations) const;
  void forgetMade() override
  {
    given_location_.reset();
    location_mesh_.reset();
  }

  DrivePoints drive_points_; ///< of all passes
  std::vector<std::size_t> pass_sizes_;
  double path_tolerance_ = 0.0;
  double ceiling_ = 0.0;
  CutterShape cutter_;
  LocationOptions options_;
  ProgressCallback progress_;
  std::shared_ptr<const LocationSurface> given_location_, location_surface_;
  std::shared_ptr<const LocationMesh> location_mesh_;
  LocationReport figures_;
  BisectionReport bisection_figures_;
};

/** Checks drive points: there must be some, all finite and each with an axis. */
Status checkDrivePoints(const DrivePoints& drive);

} // namespace pcl_spiral

#include <pcl_spiral/cutter/impl/cutter_location.hpp>

namespace pcl_spiral {
extern template class CutterLocation<pcl::PointXYZ>;
extern template class CutterLocation<pcl::PointXYZRGB>;
extern template class CutterLocation<pcl::PointNormal>;
} // namespace pcl_spiral
