// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  All figures of a finished path over an exact part: heights left, length, motion, faults. Lengths
 * in mm.
 */
#pragma once

#include "support/checked_path.h"
#include "support/left_heights.h"
#include "support/path_motion.h"
#include "support/surfaces.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_spiral::test {

/** Settings for judging a path. */
struct JudgeSettings {
  double tool_radius = 0.0, scallop_height = 0.0;
  std::size_t samples = 200000; ///< over the whole true surface
  std::uint64_t seed = 77;
  double margin = 0.1;                         ///< heights inside the rims count from here on, pitches
  double spacing = 0.0;                        ///< of the cloud; loops within three of an outline are its rim
  double longest_move = 0.0;                   ///< longer ones are jumps, which cut nothing; 0: the tool radius
  double speed = 100.0, acceleration = 2000.0; ///< mm/s, mm/s^2
  PlaneLoop gap;                               ///< in the chart, the gap of the scan; may be empty
  int threads = 0;
};

/** The figures of a path. Heights in h, lengths in mm, radii in pitches. */
struct JudgedReport {
  double pitch = 0.0;                                 ///< exact step-over on the plane
  double turns = 0.0;                                 ///< largest distance from the rims in pitches
  std::size_t rims_missed = 0;                        ///< outlines that no loop follows: the true one counts
  bool over_gap = false;                              ///< the gap is machined like the rest; otherwise its loop counts as a rim
  HeightReport inside;                                ///< within the fitted rims by the margin
  HeightReport whole;                                 ///< over the whole true surface
  double length = 0.0, least = 0.0, least_true = 0.0; ///< least within the fitted rims; within the true ones
  double outside_share = 0.0;                         ///< of the length, over half a pitch beyond the true rims
  Place outside;                                      ///< farthest; value: mm beyond
  double seconds = 0.0;
  TurningReport turning;
  ReversalReport reversals;
  std::vector<Place> crossings, jumps;
  std::vector<StockSample> samples; ///< for a picture

  double lengthRatio() const { return length / least; }
  double trueRatio() const { return length / least_true; }
  /** Machine time divided by the time for the least length at full speed. */
  double timeRatio(const JudgeSettings& s) const { return seconds * s.speed / least; }
  std::size_t passes() const { return jumps.size() + 1; }
};

/** Judges \p path over \p surface; \p loops: the boundaries that the planner found, in any order. */
JudgedReport judgedPath(const AnalyticSurface& surface, const std::vector<Polyline>& loops, const CheckedPath& path,
                        const JudgeSettings& settings);

} // namespace pcl_spiral::test
