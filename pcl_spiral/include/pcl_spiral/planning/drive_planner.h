// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  From a scan of a part among other things, or from a mesh, to gouge-free passes of any cutter.
 */
#pragma once

#include <pcl_spiral/common/impl/thread_limit.h>
#include <pcl_spiral/drive/drive_input.h>
#include <pcl_spiral/planning/impl/drive_planning.h>
#include <pcl_spiral/planning/part_input.h>

#include <utility>
#include <vector>

namespace pcl_spiral {

/** Plans passes over the part of a scan, or over a mesh, as pcl_spiral_drive does: drive path (DrivePath), cutter locations
 *  (CutterLocation), locations left out that would enter keep-outs or what stands beside the part, the check of the holder on the way
 *  between them, and of the scallop height.
 *
 *  Takes the whole scan and chooses the part, as SpiralPlanner does. Several regions give their passes one after the other. Lengths in mm.
 *  \code
 *  DrivePlanner<pcl::PointXYZ> planner;
 *  planner.setInputCloud(scan);
 *  planner.setCutter(CutterShape::ball(6.0));
 *  planner.setStepOver(1.0);
 *  planner.addKeepOut(clamp);
 *  std::vector<ToolPoses> passes;
 *  planner.compute(passes);
 *  if (!planner.getStatus().ok()) ...    // and there are no passes
 *  \endcode
 *  Contacts on a mesh keep to setChordError and the moves between locations to PassSettings::tolerance; half of the tolerance is a usual
 *  chord error. A surface (setInputSurface) is refused: it has no scan beside it. The same input gives the same bytes for any number of
 *  threads.
 */
template <typename PointT>
class DrivePlanner : public HolderInput<DriveInput<PointT>> {
public:
  using Ptr = pcl::shared_ptr<DrivePlanner>;            ///< A shared pointer.
  using ConstPtr = pcl::shared_ptr<const DrivePlanner>; ///< A shared pointer to a constant one.

  /** How locations of the tool are found. Cutter, holder, its clearance, accept_collisions and threads of these are not used: they have
   *  setters of their own. */
  void setPassSettings(const PassSettings& settings) { tool_ = settings; }
  const PassSettings& getPassSettings() const { return tool_; } ///< The value of setPassSettings.

  /** Passes of the user's own in place of the drive path, such as those of DrivePath or MeshSections with some left out. They belong to
   *  one region. Empty, the default: the drive path. */
  void setDrivePasses(DrivePasses passes) { passes_ = std::move(passes); }
  const DrivePasses& getDrivePasses() const { return passes_; } ///< The value of setDrivePasses.

  /** How a mesh that is given as polygons is prepared. */
  void setMeshSettings(const MeshSettings& settings) { mesh_settings_ = settings; }
  const MeshSettings& getMeshSettings() const { return mesh_settings_; } ///< The value of setMeshSettings.

  /** Points off the scanned surface are left out before all else, with a warning (OutlierRemoval); off by default. */
  void setLeaveOutStrays(bool leave_out) { leave_out_strays_ = leave_out; }
  bool getLeaveOutStrays() const { return leave_out_strays_; } ///< The value of setLeaveOutStrays.
  /** If false, the cutter stands at the contacts of a mesh, and nothing looks at the rest of it; true by default. */
  void setGougeCheck(bool check) { check_gouges_ = check; }
  bool getGougeCheck() const { return check_gouges_; } ///< The value of setGougeCheck.
  /** The plan has samples of the mesh, by which ProgramPlanner checks leads; on by default. */
  void setSampleMesh(bool sample) { sample_mesh_ = sample; }
  bool getSampleMesh() const { return sample_mesh_; } ///< The value of setSampleMesh.

  /** Plans the passes. \p passes is empty on failure; see getStatus. */
  void compute(std::vector<ToolPoses>& passes)
  {
    compute();
    passes = plan_.passes;
  }

  /** The same; the passes are in getPlan alone. */
  void compute()
  {
    plan_ = PassPlan();
    this->computeBy("DrivePlanner", [this] { return run(); });
  }

  const PassPlan& getPlan() const { return plan_; } ///< The last plan.
  /** Warnings of the last plan: of choosing the part, and of the passes. */
  Diagnostics getWarnings() const
  {
    Diagnostics warnings = plan_.chosen.warnings;
    warnings.insert(warnings.end(), plan_.warnings.begin(), plan_.warnings.end());
    return warnings;
  }

private:
  Status run()
  {
    if (this->given_surface_)
      return {StatusCode::InvalidArgument, "{setInputSurface} was called, but the whole scan is needed, which tells what stands beside the "
                                           "part: give the {cloud} ({setInputCloud}), or use {DrivePath} and {CutterLocation}"};
    if (const Status status = checkThreads(this->getNumberOfThreads()); !status.ok())
      return status;
    const ThreadLimit limit(this->getNumberOfThreads());
    if (const Status status = this->on_mesh_ ? this->prepareMesh(mesh_settings_) : this->checkScan(); !status.ok())
      return status;
    DrivePlanInput input;
    input.surface = this->surfaceSettings();
    if (this->on_mesh_) {
      if (const Status status =
              checkBesideMesh(this->surfaceSettings(), this->getInputNormals() != nullptr, this->givenIndices() != nullptr);
          !status.ok())
        return status;
      input.mesh = this->mesh_;
    }
    else {
      input.cloud = cloudOf<pcl::PointXYZ>(this->input_);
      input.normals = this->getInputNormals();
      input.indices = this->givenIndices();
    }
    input.leave_out_strays = leave_out_strays_;
    input.sample_mesh = sample_mesh_;
    input.check_gouges = check_gouges_;
    input.choice = this->choice();
    input.regions = this->regions_;
    input.passes = passes_;
    input.drive = this->settings_;
    input.tool = tool_;
    input.tool.holder = this->holder_;
    input.tool.holder_clearance = this->holder_clearance_;
    input.tool.accept_collisions = this->accept_collisions_;
    input.tool.threads = this->getNumberOfThreads();
    input.progress = this->progress_;
    return planDrivePasses(input, plan_);
  }

  DrivePasses passes_;
  PassSettings tool_;
  MeshSettings mesh_settings_;
  bool leave_out_strays_ = false, check_gouges_ = true, sample_mesh_ = true;
  PassPlan plan_;
};

} // namespace pcl_spiral
