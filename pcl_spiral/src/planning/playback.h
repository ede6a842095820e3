// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A judged path or program in time: the tool, and the stock that falls.
 */
#pragma once

#include "machine/motion_track.h"
#include "verify/stock_falls.h"
#include <pcl_spiral/core/control_model.h>
#include <pcl_spiral/machine/program_file.h>
#include <pcl_spiral/planning/impl/path_judge.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace pcl_spiral {

/** What is played. Lengths in mm. */
struct PlaybackInput {
  pcl::PointCloud<ToolpathPoint>::ConstPtr path; ///< JudgedPath::path: contacts
  Polyline tips;                                 ///< one a point; empty: from the contacts
  CutterShape cutter;                            ///< must be given
  std::vector<std::size_t> lines;                ///< ProgramFileReport::lines of the path; empty: no program was judged
  std::optional<ProgramFile> program;            ///< that was judged; absent: one is made of the path
  Machine machine;                               ///< that makes a path
  double feed = 1000.0;                          ///< of a path, mm/min
  ControlModel control;                          ///< see controlModel
};

/** Program and path in time. */
struct PlaybackTime {
  MotionTrack track;
  std::vector<double> reached;    ///< when the cutter is at each point of the path, s; ascends
  std::vector<std::size_t> lines; ///< of the text of each block, from 1; empty: there is no text
};

/** Finds the times. Takes the program out of \p input. A path becomes a program of the machine, with retracts between its passes, and
 *  leads. Blocks of a program that the judge found to be leads become BlockSection::LeadIn. Fails as MachineProgramGenerator, and on a
 *  program whose times are not known. */
Status playbackTime(PlaybackInput& input, PlaybackTime& time);

/** How many moves of the path are complete after \p seconds. */
std::size_t movesAfter(const PlaybackTime& time, double seconds);

/** The falls of the stock over \p mesh, that of \p judged, along its path. \p progress: see stockFalls; when it cancels, there are none. */
Status playbackStock(const PlaybackInput& input, const StockMesh& mesh, const RemovalReport& judged, StockFalls& falls,
                     const std::function<bool(double)>& progress = {});

} // namespace pcl_spiral
