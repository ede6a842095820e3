// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Judges paths and programs by the part of a scan, or by a mesh.
 */
#pragma once

#include <pcl_spiral/machine/program_file.h>
#include <pcl_spiral/planning/impl/path_judging.h>
#include <pcl_spiral/planning/part_choice.h>

#include <pcl/pcl_base.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pcl_spiral {

class RegionPasses;

/** What paths are judged by. Either a scan or a mesh is given, by settings. */
struct JudgedInput {
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr cloud; ///< the whole scan
  pcl::PointCloud<pcl::Normal>::ConstPtr normals; ///< one for each point; null: none
  pcl::IndicesPtr indices;                        ///< points of the part; null: all
  SurfaceSettings surface;                        ///< of the scan
  PartChoice choice;                              ///< without its region
  std::vector<PlanRegion> regions;                ///< several: a pass belongs to the one it is nearest to
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr raw;   ///< the scan before it was smoothed; null: none
  std::string raw_name = "the raw scan";          ///< for messages
  Limits limits;                                  ///< that a path must keep
  JudgeSettings settings;                         ///< cutter, heights and mesh; cutter without a radius: only deviations are judged
  ProgressCallback progress;                      ///< may be empty
};

/** A path as it is given to a judge. */
struct GivenPath {
  pcl::PointCloud<ToolpathPoint>::ConstPtr path; ///< contacts; null: see program
  Polyline tips;                                 ///< one for each point; empty: not known
  bool has_contacts = true;                      ///< false: only tips and axes are known, and contacts are found on the scan
  std::optional<ProgramFile> program;            ///< judged in place of a path
};

/** A path and its judgement. */
struct JudgedPath {
  pcl::PointCloud<ToolpathPoint>::Ptr path = pcl::make_shared<pcl::PointCloud<ToolpathPoint>>(); ///< contacts, of one region
  Polyline tips; ///< of a cutter that is no ball; empty: from its contacts
  Verification verification;
  Heights heights;
};

/** A region of the part of a scan, or a mesh. */
struct JudgedPart {
  std::string region;                                ///< its name; empty: it is the only one
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr cloud;    ///< its points; null: a mesh
  pcl::PointCloud<pcl::Normal>::ConstPtr normals;    ///< one for each of them; null: none
  ChosenPart chosen;                                 ///< of the scan
  ClusterHandling clusters = ClusterHandling::Ride;  ///< what clusters on it are
  std::shared_ptr<const ReferenceSurface> reference; ///< its surface; null until a path is judged
  std::optional<RawScanReport> raw;                  ///< the raw scan beside it; absent until a path is judged, and without one
};

/** Judges one path after the other; the surface of each region is made once. */
class PathJudge {
public:
  PathJudge();
  ~PathJudge();

  /** Chooses the points of each region, at least one; near keep-outs those that a tool leaves which leans by \p lean degrees. */
  Status prepare(const JudgedInput& input, double lean);
  const std::vector<JudgedPart>& parts() const { return parts_; }
  /** Called from now on; may be empty. */
  void setProgress(const ProgressCallback& progress);

  /** Makes the surface of \p region of a scan, if there is none yet. */
  Status makeReference(std::size_t region);
  /** The way of \p given over \p region into \p judged, with what its file is wrong in: tips, axes beyond their limits, moves that do not
   *  cut and collide, missing blocks. */
  Status read(const GivenPath& given, std::size_t region, JudgedPath& judged);
  /** Reads \p given, and judges it by \p region with verdicts. */
  Status judge(const GivenPath& given, std::size_t region, JudgedPath& judged);

private:
  Status makeReference(std::size_t region, double from, double to);
  Status readContacts(const GivenPath& given, std::size_t region, JudgedPath& judged);
  Status readProgram(const ProgramFile& file, std::size_t region, JudgedPath& judged);
  Status checkOtherMoves(const ProgramFile& read, const JudgedPart& part, ProgramFileReport& figures) const;

  JudgedInput input_;
  std::vector<JudgedPart> parts_;
  std::unique_ptr<RegionPasses> passes_; ///< null: there is one region
};

/** How far the tool of \p given leans from the normals of the part, degrees, for PathJudge::prepare; 0 without keep-outs. Where there are
 *  no contacts, over several regions it is that of a tool that SpiralPlanner makes by default. \p of_scan: whether a failure is one of
 *  the scan, and not of the path. */
Status toolLean(const JudgedInput& input, const GivenPath& given, double& lean, bool& of_scan);

/** Judges \p given by each region of the part, with verdicts. Refuses what it cannot be judged with: no cutter, no path, a thinned scan. */
Status verifyPath(const JudgedInput& input, const GivenPath& given, PathJudge& judge, std::vector<JudgedPath>& judged);

} // namespace pcl_spiral
