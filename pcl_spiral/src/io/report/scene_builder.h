// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Puts a scene together. Private to io and the programs.
 */
#pragma once

#include "scene_frames.h"

#include <pcl_spiral/machine/program_file.h>
#include <pcl_spiral/planning/impl/path_judging.h>
#include <pcl_spiral/verify/verification.h>

#include <memory>
#include <vector>

namespace pcl_spiral {

/** First parts, tool and moves in any order, then build. */
class SceneBuilder {
public:
  SceneBuilder(const CutterShape& cutter, const std::vector<ToolSegment>& holder);

  /** Adds the part of a scan. \p judged: by the points of \p cloud_size; null: not judged. */
  void addScan(const Surface& surface, const Heights* judged);
  /** Adds a mesh. \p judged: by its samples; null: not judged. */
  void addFaces(const SurfaceMesh& mesh, const Heights* judged);
  /** Adds a path, after the one before. */
  void addPath(const ShownPath& path, const std::vector<std::size_t>& lines = {});
  /** Takes the blocks of \p program for moves along \p path. */
  void setProgram(const ShownProgram& program, const ShownPath& path);
  /** The same of a program that was judged along \p path. If its times are not known, it is shown as the path. */
  void addProgram(const ProgramFile& program, const ProgramFileReport& judged, const ShownPath& path);
  /** The figures behind the colours; of several regions the widest range counts. \p chord_error: of the path, mm. */
  void addFigures(const Verification& judged, double chord_error);
  /** What the numbers of turns are: Turn, or Pass. */
  void setTurnWord(const char* word) { scene_.turn_word = word; }

  /** Thins it to what a page holds; notes say by how much. */
  std::shared_ptr<const ReportScene> build();

private:
  void takeTurns(const pcl::PointCloud<ToolpathPoint>& path);
  void thin();
  void findOutward();

  ReportScene scene_;
  pcl::PointCloud<ToolpathPoint>::Ptr path_ = pcl::make_shared<pcl::PointCloud<ToolpathPoint>>(); ///< all paths as one
  Polyline tips_;                                                                                 ///< one for each of its points; or empty
  std::vector<double> reached_; ///< when the tool is at each of its points
  RemovalReport judged_;        ///< limit and reach, the largest of all regions
};

} // namespace pcl_spiral
