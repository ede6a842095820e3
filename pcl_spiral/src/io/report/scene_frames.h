// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The moves of a tool as frames of a page. Private to io.
 */
#pragma once

#include "report_scene.h"

#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/machine/machine_program.h>
#include <pcl_spiral/machine/motion_time.h>

#include <pcl/point_cloud.h>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** That of times where no feed is known, mm/min. */
constexpr double feed_if_none = 1000.0;

/** A path as it is shown. Lengths in mm. */
struct ShownPath {
  pcl::PointCloud<ToolpathPoint>::ConstPtr points; ///< contacts
  Polyline tips;                                   ///< one for each point; empty: those of a ball
  std::vector<std::size_t> begins;                 ///< where the second pass and each further one begin
  double feed = 0.0;                               ///< mm/min; 0: not known
  std::vector<double> feeds;                       ///< of each point, in place of one feed of all; or empty
  std::vector<float> deviation;                    ///< one for each point; empty: not measured
};

/** A program as it is shown. Times in s since the start. */
struct ShownProgram {
  const MachineProgram& program;
  std::vector<double> ends;         ///< of each block
  std::vector<double> reached;      ///< when the tool is at each point of the path, ascending
  std::vector<std::size_t> numbers; ///< of the line of each block; empty: blocks are counted
};

/** \p program, which was made of \p path. Times are those of \p motion, or if it is null, or the time is not known, of the feeds. */
ShownProgram shownProgram(const MachineProgram& program, const MotionStudy* motion, const ShownPath& path);

/** The tool of \p cutter along \p path at its feed: a frame for each point. Between passes it jumps: only a machine makes these moves. */
std::vector<SceneFrame> framesOf(const ShownPath& path, const CutterShape& cutter);

/** The tool at the end of each block of \p program. Contacts, turns and deviations are those of the point of \p path reached last. */
std::vector<SceneFrame> framesOf(const ShownProgram& program, const ShownPath& path);

/** Leaves out frames until there are at most \p most. Returns how far the tips of those left out are from the moves that are left. */
double thinFrames(std::size_t most, std::vector<SceneFrame>& frames);

/** When the tool passes each place of \p part, and the deviation of its contact there: that of the nearest contact, if it is not farther
 *  away than \p reach. */
void passPlaces(const std::vector<SceneFrame>& frames, double reach, ScenePart& part);

} // namespace pcl_spiral
