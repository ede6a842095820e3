// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Places of a surface at which the coverage of a path is tested.
 */
#pragma once

#include "spiral/lines/segment_set.h"

#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/spiral/loop_linking.h>
#include <pcl_spiral/spiral/step_over_field.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace pcl_spiral {

/** A place farther than this from the path moves the path, step-overs. */
constexpr double covered = 0.503;

/** Places that must not be farther than half a step-over from a path. Parallel arrays. */
struct CoverTests {
  Polyline points;
  std::vector<StepOverMetric> metric;
  std::vector<std::size_t> seeds;      ///< a segment that may be near, or NearestSegment::none; empty when all are measured
  std::vector<NearestSegment> nearest; ///< from the path, at most 1.5; upper limits where that is enough, see measure

  std::size_t size() const { return points.size(); }
  void add(const Eigen::Vector3d& p, const StepOverMetric& m);
  void reserve(std::size_t size);
  void resize(std::size_t size);
  /** Measure the distances, from index \p first on: those that are more than \p exact, and upper limits of the others. Returns false if
   *  \p progress cancels. */
  bool measure(const SegmentSet& lines, std::size_t first, double exact, const std::function<bool(double)>& progress);
};

/** The passes of a path; a run's label is its first point. */
SegmentSet passLines(const LinkedPath& path);

/** Places on and beside the ridges of \p field, places where it is not a true distance, and places at the links of \p path: between
 *  the turns of ramps and about bridges. \p line holds the points of the path. Returns false if \p progress cancels. */
bool coverTests(const StepOverDistance& field, const LinkedPath& path, const SegmentSet& line, const ProgressCallback& progress,
                CoverTests& tests);

} // namespace pcl_spiral
