// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Judges a finished path by the scan, or by the mesh, that it is meant for.
 */
#pragma once

#include <pcl_spiral/common/impl/thread_limit.h>
#include <pcl_spiral/mesh/impl/mesh_input.h>
#include <pcl_spiral/planning/impl/path_judging.h>
#include <pcl_spiral/planning/part_input.h>

#include <memory>
#include <utility>

namespace pcl_spiral {

/** Judges a path as pcl_spiral_verify does: deviation of its contacts (DeviationEstimation), what its cutter leaves and cuts
 *  (MaterialRemoval), limits, and what it meets beside the part: keep-outs, what stands in them, the rest of the scan, clusters.
 *
 *  Takes the whole scan and the same choice of the part as the planner that made the path, whose report it does not use. A path of several
 *  regions is judged region by region: addRegion takes one, and the path its passes. Lengths in mm.
 *  \code
 *  PathVerifier<pcl::PointXYZ> verifier;
 *  verifier.setInputCloud(scan);
 *  verifier.setInputToolpath(path);
 *  verifier.setCutter(CutterShape::ball(6.0));
 *  verifier.setScallopHeight(0.05);
 *  Verification found;
 *  verifier.compute(found);
 *  if (!verifier.getStatus().ok()) ...   // could not be judged
 *  if (!found.broken.empty()) ...        // each says what is wrong, and where
 *  \endcode */
template <typename PointT>
class PathVerifier : public PartInput<MeshInput<PointT>> {
public:
  using Ptr = pcl::shared_ptr<PathVerifier>;                               ///< A shared pointer.
  using ConstPtr = pcl::shared_ptr<const PathVerifier>;                    ///< A shared pointer to a constant one.
  using PathConstPtr = typename pcl::PointCloud<ToolpathPoint>::ConstPtr;  ///< A path, shared.
  using CloudConstPtr = typename pcl::PointCloud<pcl::PointXYZ>::ConstPtr; ///< The raw scan, shared.

  /** Clusters are to be ridden over by default: a path is judged in any case. */
  PathVerifier()
  {
    this->setClusterHandling(ClusterHandling::Ride);
    judge_.scallop_height = 0.05;
    judge_.chord_error = 0.005;
  }

  /** The path. */
  void setInputToolpath(const PathConstPtr& path) { path_ = path; }
  const PathConstPtr& getInputToolpath() const { return path_; } ///< The value of setInputToolpath.
  /** How a mesh that is given as polygons (setInputMesh) is prepared. A mesh is judged by in place of the scan; settings, crops, keep-outs
   *  and regions that belong to scans are refused with it. */
  void setMeshSettings(const MeshSettings& settings) { mesh_settings_ = settings; }
  const MeshSettings& getMeshSettings() const { return mesh_settings_; } ///< The value of setMeshSettings.
  /** Distance of the samples of the mesh, mm; 0, the default: from its curvature. */
  void setSampleSpacing(double spacing) { judge_.sample_spacing = spacing; }
  double getSampleSpacing() const { return judge_.sample_spacing; } ///< The value of setSampleSpacing.
  /** Tips of a cutter that is no ball, one for each point; empty, the default: those of a ball at its contacts. */
  void setInputTips(const Polyline& tips) { judge_.tips = tips; }
  const Polyline& getInputTips() const { return judge_.tips; } ///< The value of setInputTips.
  /** The scan before it was smoothed: the path must not cut into it either. Null, the default: there is none. */
  void setRawScan(const CloudConstPtr& raw) { raw_ = raw; }
  const CloudConstPtr& getRawScan() const { return raw_; } ///< The value of setRawScan.

  /** The cutter. Must be set. */
  void setCutter(const CutterShape& cutter) { judge_.cutter = cutter; }
  const CutterShape& getCutter() const { return judge_.cutter; } ///< The value of setCutter.
  /** Scallop height that the path was made for, mm; 0.05 by default. */
  void setScallopHeight(double height) { judge_.scallop_height = height; }
  double getScallopHeight() const { return judge_.scallop_height; } ///< The value of setScallopHeight.
  /** Chord error that the path was made for, mm; 0.005 by default. */
  void setChordError(double error) { judge_.chord_error = error; }
  double getChordError() const { return judge_.chord_error; } ///< The value of setChordError.
  /** What the path must keep; none by default: then only wrong poses and collisions break it. */
  void setLimits(const Limits& limits) { limits_ = limits; }
  const Limits& getLimits() const { return limits_; } ///< The value of setLimits.

  /** Called with the share done; return false to cancel. */
  void setProgressCallback(ProgressCallback callback) { progress_ = std::move(callback); }

  /** Judges the path. \p verification has no figures on failure; see getStatus. */
  void compute(Verification& verification)
  {
    verification = Verification();
    heights_ = Heights();
    reference_.reset();
    Verification found;
    Heights heights;
    std::shared_ptr<const ReferenceSurface> reference;
    if (!this->computeBy("PathVerifier", [&] { return run(reference, found, heights); }))
      return;
    verification = std::move(found);
    heights_ = std::move(heights);
    reference_ = std::move(reference);
  }

  const Heights& getHeights() const { return heights_; } ///< Values behind the figures, for pictures and maps.
  /** The surface that the last path was judged by; null if it was not. */
  const std::shared_ptr<const ReferenceSurface>& getReferenceSurface() const { return reference_; }

private:
  Status run(std::shared_ptr<const ReferenceSurface>& reference, Verification& verification, Heights& heights)
  {
    if (this->given_surface_)
      return {StatusCode::InvalidArgument, "{setInputSurface} was called, but the whole scan is needed, which tells what stands beside the "
                                           "part: give the {cloud} ({setInputCloud}), or use {DeviationEstimation} and {MaterialRemoval}"};
    if (const Status status = checkThreads(this->getNumberOfThreads()); !status.ok())
      return status;
    const ThreadLimit limit(this->getNumberOfThreads());
    if (const Status status = this->on_mesh_ ? this->prepareMesh(mesh_settings_) : this->checkInput(); !status.ok())
      return status;
    JudgedInput input;
    input.settings = judge_;
    if (this->on_mesh_) {
      SurfaceSettings asked = this->surfaceSettings();
      asked.clusters = SurfaceSettings().clusters; // of a scan
      if (const Status status = checkBesideMesh(asked, this->getInputNormals() != nullptr, this->givenIndices() != nullptr); !status.ok())
        return status;
      input.settings.mesh = this->mesh_;
    }
    else {
      input.cloud = cloudOf<pcl::PointXYZ>(this->input_);
      input.normals = this->getInputNormals();
      input.indices = this->givenIndices();
    }
    input.surface = this->surfaceSettings();
    input.choice = this->choice();
    input.regions = this->regions_;
    input.path = path_;
    input.raw = raw_;
    input.limits = limits_;
    input.progress = progress_;
    return verifyPath(input, reference, verification, heights);
  }

  PathConstPtr path_;
  CloudConstPtr raw_;
  Limits limits_;
  JudgeSettings judge_;
  MeshSettings mesh_settings_;
  ProgressCallback progress_;
  Heights heights_;
  std::shared_ptr<const ReferenceSurface> reference_;
};

} // namespace pcl_spiral
