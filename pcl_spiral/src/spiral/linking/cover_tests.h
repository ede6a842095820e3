// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Places of a surface at which the coverage of a path is tested.
 */
#pragma once

#include "spiral/lines/segment_set.h"

#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/spiral/loop_linking.h>
#include <pcl_spiral/spiral/step_over_field.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace pcl_spiral {

/** A place farther than this from the path moves the path, step-overs. */
constexpr double covered = 0.503;
/** Segments farther than this from a place do not count, step-overs. */
constexpr double covering_within = 1.5;

/** What of a path is nearest to a place. */
struct Covering {
  static constexpr std::uint32_t none = 0xffffffffu;
  double distance = 0.0;        ///< step-overs, at most covering_within; an upper limit where that is enough
  std::uint32_t segment = none; ///< from its point of the path to the next
  float share = 0.0f;           ///< along it
};

/** A place and its metric. */
struct CoverPlace {
  Eigen::Vector3d point;
  StepOverMetric metric;
};

/** Places that must not be farther than half a step-over from a path: on and beside the ridges of a field, where it is not a true
 *  distance, and at the links of the path: between the turns of ramps and about bridges. There are millions on large parts, so only
 *  their distances are kept: a place is computed when it is asked for. */
class CoverTests {
public:
  CoverTests(const StepOverDistance& field, const LinkedPath& path) : field_(field), mesh_(field.mesh), path_(path) {}

  /** Measure the distances of all places from \p line, the points of the path. Returns false if \p progress cancels. */
  bool run(const SegmentSet& line, const ProgressCallback& progress);

  std::size_t size() const { return links_begin_ + path_.links.size(); }
  CoverPlace place(std::size_t test) const;
  const Covering& nearest(std::size_t test) const { return nearest_[test]; }
  /** Forget the distances. */
  void forgetNearest() { std::vector<Covering>().swap(nearest_); }

private:
  /** A triangle whose parts are tested. */
  struct TestedTriangle {
    std::uint32_t triangle, parts;      ///< it is cut into parts * parts
    std::size_t first;                  ///< index of the first test
    std::array<std::uint32_t, 3> seeds; ///< segments near its corners
  };

  void chooseNodes();
  void chooseTriangles();
  std::size_t triangleOf(std::size_t test) const;
  CoverPlace nodePlace(std::uint32_t v) const { return {mesh_.positions[v], mesh_.metric[v]}; }
  CoverPlace partPlace(const TestedTriangle& tested, std::size_t part, std::uint32_t& seed) const;
  CoverPlace placeAt(std::size_t test, std::size_t& tested, std::uint32_t& seed) const;
  bool measure(const SegmentSet& line, std::size_t first, double exact, const std::function<bool(double)>& progress);

  const StepOverDistance& field_;
  const StepOverMesh& mesh_;
  const LinkedPath& path_;
  std::vector<std::uint32_t> nodes_;   ///< the first tests
  std::vector<TestedTriangle> tested_; ///< the next tests
  std::size_t links_begin_ = 0;        ///< the links of the path are the last ones
  std::vector<Covering> nearest_;
};

/** The passes of a path; a run's label is its first point. */
SegmentSet passLines(const LinkedPath& path);

} // namespace pcl_spiral
