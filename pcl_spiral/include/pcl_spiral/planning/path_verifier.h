// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Judges a finished path or program by the scan, or by the mesh, that it is meant for.
 */
#pragma once

#include <pcl_spiral/common/impl/thread_limit.h>
#include <pcl_spiral/mesh/impl/mesh_input.h>
#include <pcl_spiral/planning/impl/path_judge.h>
#include <pcl_spiral/planning/part_input.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace pcl_spiral {

/** Judges a path or a program as pcl_spiral_verify does: deviation of its contacts (DeviationEstimation), what its cutter leaves and cuts
 *  (MaterialRemoval), limits, and what it meets beside the part: keep-outs, what stands in them, the rest of the scan, clusters. Of a
 *  program, what the control will do is judged: its moves between the blocks, its axes' limits, and what the tool meets on moves that do
 *  not cut.
 *
 *  Takes the whole scan and the same choice of the part as the planner that made the path, whose report it does not use. With several
 *  regions (addRegion) each pass belongs to the region that it is nearest to, and there is a verification of each. Lengths in mm.
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
  PathVerifier() { this->setClusterHandling(ClusterHandling::Ride); }

  /** The path: contacts. Takes back setInputProgram. */
  void setInputToolpath(const PathConstPtr& path)
  {
    given_.path = path;
    given_.program.reset();
  }
  const PathConstPtr& getInputToolpath() const { return given_.path; } ///< The value of setInputToolpath.
  /** A program that was read back (readProgram), judged in place of a path. It needs a scan: the cutter's contacts are found on it. */
  void setInputProgram(const ProgramFile& program) { given_.program = program; }
  const std::optional<ProgramFile>& getInputProgram() const { return given_.program; } ///< The value of setInputProgram.
  /** Whether the path has contacts, the default. Without them it has tips (setInputTips) and axes, and contacts are found on the scan. */
  void setHasContacts(bool has_contacts) { given_.has_contacts = has_contacts; }
  bool getHasContacts() const { return given_.has_contacts; } ///< The value of setHasContacts.
  /** How a mesh that is given as polygons (setInputMesh) is prepared. A mesh is judged by in place of the scan; settings, crops, keep-outs
   *  and regions that belong to scans are refused with it. */
  void setMeshSettings(const MeshSettings& settings) { mesh_settings_ = settings; }
  const MeshSettings& getMeshSettings() const { return mesh_settings_; } ///< The value of setMeshSettings.
  /** Distance of the samples of the mesh, mm; 0, the default: from its curvature. */
  void setSampleSpacing(double spacing) { judge_.sample_spacing = spacing; }
  double getSampleSpacing() const { return judge_.sample_spacing; } ///< The value of setSampleSpacing.
  /** Tips of the cutter as they stand in a file, one for each point; empty, the default: those of a ball at its contacts. Those of a cutter
   *  that is no ball are judged, those of a ball compared with its contacts (Verification::tips_off). */
  void setInputTips(const Polyline& tips) { given_.tips = tips; }
  const Polyline& getInputTips() const { return given_.tips; } ///< The value of setInputTips.
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

  /** Judges the path by one region, or by all of the part. \p verification has no figures on failure; see getStatus. */
  void compute(Verification& verification)
  {
    std::vector<Verification> found;
    judgeRegions(1, found);
    verification = found.empty() ? Verification() : std::move(found.front());
  }

  /** Judges the path by each region; \p verifications are in their order, empty on failure. */
  void compute(std::vector<Verification>& verifications) { judgeRegions(this->regions_.size(), verifications); }

  /** Values behind the figures of \p region, for pictures and maps. */
  const Heights& getHeights(std::size_t region = 0) const { return region < judged_.size() ? judged_[region].heights : nothing_.heights; }
  /** The contacts that were judged over \p region: those of the path, or of the cutter on the moves of a program. */
  PathConstPtr getJudgedPath(std::size_t region = 0) const { return region < judged_.size() ? judged_[region].path : nothing_.path; }
  /** The surface of \p region that the last path was judged by; null if it was not. */
  std::shared_ptr<const ReferenceSurface> getReferenceSurface(std::size_t region = 0) const
  {
    return region < references_.size() ? references_[region] : nullptr;
  }

private:
  void judgeRegions(std::size_t most_regions, std::vector<Verification>& verifications)
  {
    verifications.clear();
    judged_.clear();
    references_.clear();
    PathJudge judge;
    std::vector<JudgedPath> judged;
    if (!this->computeBy("PathVerifier", [&] { return run(most_regions, judge, judged); }))
      return;
    judged_ = std::move(judged);
    for (const JudgedPart& part : judge.parts())
      references_.push_back(part.reference);
    for (const JudgedPath& path : judged_)
      verifications.push_back(path.verification);
  }

  Status run(std::size_t most_regions, PathJudge& judge, std::vector<JudgedPath>& judged)
  {
    if (this->given_surface_)
      return {StatusCode::InvalidArgument, "{setInputSurface} was called, but the whole scan is needed, which tells what stands beside the "
                                           "part: give the {cloud} ({setInputCloud}), or use {DeviationEstimation} and {MaterialRemoval}"};
    if (this->regions_.size() > std::max<std::size_t>(most_regions, 1))
      return {StatusCode::InvalidArgument,
              Diagnostic(this->regions_.size(), " regions are given ({addRegion}), and each has a verification "
                                                "of its own: call compute with a vector of them")};
    if (const Status status = checkThreads(this->getNumberOfThreads()); !status.ok())
      return status;
    const ThreadLimit limit(this->getNumberOfThreads());
    if (const Status status = this->on_mesh_ ? this->prepareMesh(mesh_settings_) : this->checkScan(); !status.ok())
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
    input.raw = raw_;
    input.limits = limits_;
    input.progress = progress_;
    return verifyPath(input, given_, judge, judged);
  }

  GivenPath given_;
  CloudConstPtr raw_;
  Limits limits_;
  JudgeSettings judge_;
  MeshSettings mesh_settings_;
  ProgressCallback progress_;
  JudgedPath nothing_;             ///< of a region that was not judged
  std::vector<JudgedPath> judged_; ///< one a region
  std::vector<std::shared_ptr<const ReferenceSurface>> references_;
};

} // namespace pcl_spiral
