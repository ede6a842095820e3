// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Places of a surface at which a path's coverage is looked at.
 */
#pragma once

#include "spiral/lines/segment_set.h"

#include <pcl_spiral/spiral/loop_linking.h>
#include <pcl_spiral/spiral/step_over_field.h>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** Distance above which a place moves the path. */
constexpr double covered = 0.503;

/** Places that must not be farther than half a step-over from a path. Parallel arrays. */
struct CoverTests {
  Polyline points;
  std::vector<StepOverMetric> metric;
  std::vector<double> distances; ///< from the path, step-overs; no more than 1.5 are told

  std::size_t size() const { return points.size(); }
  void add(const Eigen::Vector3d& p, const StepOverMetric& m);
  /** Measure the distances from the one at \p first on. */
  void measure(const SegmentSet& lines, std::size_t first);
};

/** The passes of a path; a run's label is its first point. */
SegmentSet passLines(const LinkedPath& path);

/** On and beside the ridges of \p field, where it is no distance, and between the turns of ramps and about bridges: the links of
 *  \p path, whose points \p line holds. */
CoverTests coverTests(const StepOverDistance& field, const LinkedPath& path, const SegmentSet& line);

/** Those of \p tests that a path moved towards \p places, which are not covered, may uncover, and the places themselves. */
std::vector<std::size_t> testsToWatch(const CoverTests& tests, const std::vector<std::size_t>& places);

} // namespace pcl_spiral
