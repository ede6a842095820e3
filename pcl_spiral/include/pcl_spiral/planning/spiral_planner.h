// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  From a scan of a part among other things, or from a mesh, to a path that is free of all else in the scan.
 */
#pragma once

#include <pcl_spiral/common/impl/thread_limit.h>
#include <pcl_spiral/planning/impl/spiral_planning.h>
#include <pcl_spiral/planning/part_input.h>
#include <pcl_spiral/spiral/spiral_input.h>

#include <pcl/PolygonMesh.h>

#include <memory>
#include <set>
#include <string>

namespace pcl_spiral {

/** Plans spirals over the part of a scan, or over a mesh, as pcl_spiral_toolpath does.
 *
 *  SpiralToolpathGenerator takes the points of the part; this class takes the whole scan and chooses them: setPartAt, setLargestPart,
 *  setCropBox, setCrop, addKeepOut, addRegion. All else that the scan has is an obstacle: the ball rides over the surface that continues
 *  beside a crop, and a path on which ball, shank or holder enter anything is refused, with the place. Where a keep-out leaves strips in
 *  which no path is found, or the path would run into it, it is planned again without the narrowest strips, or farther from the keep-out;
 *  SpiralPlan::attempts says why. Several regions give one path of several passes, in the order of addRegion, with the tool lifted between
 *  them. Lengths in mm.
 *  \code
 *  SpiralPlanner<pcl::PointXYZ> planner;
 *  planner.setInputCloud(scan);
 *  planner.setToolRadius(10.0);
 *  planner.setScallopHeight(0.05);
 *  planner.addKeepOut(clamp);
 *  pcl::PointCloud<ToolpathPoint> path;
 *  planner.compute(path);
 *  if (!planner.getStatus().ok()) ...    // and the path is empty
 *  \endcode
 *  With setIndices only these points are of the part, as with a crop. A surface (setInputSurface) is refused: it has no scan beside it.
 *  The same input gives the same bytes for any number of threads.
 */
template <typename PointInT, typename PointNT = pcl::Normal>
class SpiralPlanner : public HolderInput<SpiralInput<PointInT, PointNT>> {
public:
  using Ptr = pcl::shared_ptr<SpiralPlanner>;            ///< A shared pointer.
  using ConstPtr = pcl::shared_ptr<const SpiralPlanner>; ///< A shared pointer to a constant one.

  /** The whole scan. Clears a mesh given before. */
  void setInputCloud(const typename pcl::PointCloud<PointInT>::ConstPtr& cloud) override
  {
    SpiralInput<PointInT, PointNT>::setInputCloud(cloud);
    setInputMesh(SurfaceMesh::ConstPtr());
  }

  /** A mesh in place of the scan: all of it is the part. Its faces define the side, and setFlipNormals turns them; keep-outs, crops,
   *  regions in polygons and filters of points belong to scans. Null, the default: the scan counts. */
  void setInputMesh(const pcl::PolygonMesh::ConstPtr& mesh)
  {
    this->given_surface_.reset();
    polygons_ = mesh;
    plan_input_.mesh.reset();
  }
  /** The same with a mesh made with your own settings; it is turned already. */
  void setInputMesh(const SurfaceMesh::ConstPtr& mesh)
  {
    this->given_surface_.reset();
    polygons_.reset();
    plan_input_.mesh = mesh;
  }
  const SurfaceMesh::ConstPtr& getInputMesh() const { return plan_input_.mesh; } ///< The mesh given, or made by the last compute.
  /** Distance of the samples of the mesh, mm; 0, the default: from the curvature of the mesh and the step-over. */
  void setSampleSpacing(double spacing) { plan_input_.sample_spacing = spacing; }
  double getSampleSpacing() const { return plan_input_.sample_spacing; } ///< The value of setSampleSpacing.

  /** Distance from the centre of the ball to the holder, mm. Must be set, above 0, if there is a holder. */
  void setFlankLength(double length) { plan_input_.flank_length = length; }
  double getFlankLength() const { return plan_input_.flank_length; } ///< The value of setFlankLength.
  /** A planner of the user's own in place of the spiral; null, the default: none. */
  void setPlanner(const std::shared_ptr<const PathPlanner>& planner) { plan_input_.planner = planner; }
  const std::shared_ptr<const PathPlanner>& getPlanner() const { return plan_input_.planner; } ///< The value of setPlanner.

  /** For a scan from one side with steps, folds and overhangs: the surface that is planned is what the ball can touch when it comes down
   *  along the tool axis (BallClosing). The axis is that of setFixedAxis, else it points to the view point, else +z, and stays the same on
   *  the whole path, so that a shank no wider than the ball meets nothing. The path is lifted off every point of the scan that it would
   *  cut. Material that the ball cannot reach from there stays. Crops and regions work as before. Of several separate parts the one that is
   *  chosen (setPartAt, setLargestPart, setIndices) ends where the others keep the ball away; without a choice a warning names them.
   *  Keep-outs and meshes are refused. SpiralPlan::surface is that of the closed scan, raised by a part of the radius; SpiralPlan::cloud is
   *  the scan. Off by default. */
  void setBallClosing(bool close) { plan_input_.ball_closing = close; }
  bool getBallClosing() const { return plan_input_.ball_closing; } ///< The value of setBallClosing.

  /** A refused input is planned again with single changes of its settings, until one gives a path that passes all checks; the refusal
   *  then names this change, with the length of its path, or else the changes that were tried and the place that another scan has to show.
   *  Such a search takes about as long as \p paths paths; a progress callback that returns false ends it with the refusal. 0: no search.
   *  A path that is found at once costs nothing more. */
  void setRemedyTries(int paths) { plan_input_.remedy_tries = paths; }
  int getRemedyTries() const { return plan_input_.remedy_tries; } ///< The value of setRemedyTries; 3 by default.
  /** Names of what is asked for beside the settings, as "verify" or "reach", options of pcl_spiral_toolpath: no change is tried that the
   *  program refuses beside one of them. None by default. */
  void setAskedNames(const std::set<std::string>& names) { plan_input_.asked = names; }
  const std::set<std::string>& getAskedNames() const { return plan_input_.asked; } ///< The value of setAskedNames.

  /** The plan has the surface of each region, as for a check of the path; off by default: it is made if planning needs it. */
  void setKeepSurface(bool keep) { plan_input_.keep_surface = keep; }
  bool getKeepSurface() const { return plan_input_.keep_surface; } ///< The value of setKeepSurface.

  /** Plans the path. \p path is empty on failure; see getStatus. */
  void compute(pcl::PointCloud<ToolpathPoint>& path)
  {
    path.clear();
    compute();
    if (!this->status_.ok())
      return;
    path = *plan_.path;
    if (this->input_)
      path.header = this->input_->header;
  }

  /** The same; the path is in getPlan alone. */
  void compute()
  {
    plan_ = SpiralPlan();
    this->computeBy("SpiralPlanner", [this] { return run(); });
  }

  const SpiralPlan& getPlan() const { return plan_; }            ///< The last plan: regions, what is left uncut, tries.
  const SpiralReport& getReport() const { return plan_.report; } ///< Figures and warnings of the last path.
  /** Warnings of the last plan: of choosing the part, and of the path. */
  Diagnostics getWarnings() const
  {
    Diagnostics warnings = plan_.part.warnings;
    warnings.insert(warnings.end(), plan_.report.warnings.begin(), plan_.report.warnings.end());
    return warnings;
  }

private:
  Status run()
  {
    if (this->given_surface_)
      return {StatusCode::InvalidArgument, "{setInputSurface} was called, but the whole scan is needed, which tells what stands beside the "
                                           "part: give the {cloud} ({setInputCloud}), or use {SpiralToolpathGenerator}"};
    if (const Status status = checkThreads(this->getNumberOfThreads()); !status.ok())
      return status;
    const ThreadLimit limit(this->getNumberOfThreads());
    if (polygons_) {
      MeshSettings settings;
      settings.flip = this->getFlipNormals();
      if (const Status status = SurfaceMesh::make(*polygons_, settings, plan_input_.mesh); !status.ok())
        return status;
    }
    else if (plan_input_.mesh && this->getFlipNormals())
      return {StatusCode::InvalidArgument, "{setFlipNormals} was called, but the mesh given is prepared already: turn it by "
                                           "{MeshSettings::flip}, or give its polygons"};
    if (!plan_input_.mesh)
      if (const Status status = this->checkScan(); !status.ok())
        return status;
    if (plan_input_.mesh && (this->getInputNormals() || this->givenIndices()))
      return {StatusCode::InvalidArgument, Diagnostic(this->getInputNormals() ? "{setInputNormals}" : "{setIndices}",
                                                      " belongs to scans, and a mesh is given ({setInputMesh}): leave one of the two out")};
    PlanInput input = plan_input_;
    input.settings = this->settings_;
    input.choice = this->choice();
    input.regions = this->regions_;
    input.holder = this->holder_;
    input.holder_clearance = this->holder_clearance_;
    input.accept_collisions = this->accept_collisions_;
    input.modifiers = this->modifiers_;
    input.progress = this->progress_;
    if (!input.mesh) {
      input.cloud = cloudOf<pcl::PointXYZ>(this->input_);
      input.normals = cloudOf<pcl::Normal>(this->getInputNormals());
      input.indices = this->givenIndices();
    }
    return planSpiral(input, plan_);
  }

  PlanInput plan_input_; ///< what is set on this class
  pcl::PolygonMesh::ConstPtr polygons_;
  SpiralPlan plan_;
};

} // namespace pcl_spiral
