// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Pairs of moves of a path that are near each other.
 */
#pragma once

#include "core/move_cells.h"

#include <pcl_spiral/core/impl/pass_ranges.h>
#include <pcl_spiral/core/polyline.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace pcl_spiral {

/** A move and a later one, as the first is walked. */
struct MovePair {
  std::size_t first, later;
  double begin, end; ///< how far the later one begins and ends to the left of the first, times the length of the first
  bool is_beside;    ///< they share a cell within the margin: they may cross

  /** False of almost all pairs: few moves have their ends on different sides of a move near them. */
  bool mayCross() const { return is_beside && begin * end < 0.0 && later > first + 1; }
};

/** Moves of a path on a surface with those near them. \p normals unit, one a point; \p passes: points before which the tool was lifted.
 *  The arguments must live as long as this. See firstSelfCrossing for what crosses. */
class MovePairs {
public:
  MovePairs(const Polyline& path, const std::vector<Eigen::Vector3d>& normals, double slack, const std::vector<std::size_t>& passes);

  /** Number of moves, lifts included; 0 if none has a length. */
  std::int64_t size() const { return cells_ ? static_cast<std::int64_t>(path_.size()) - 1 : 0; }
  bool isLift(std::size_t move) const { return beginsPass(passes_, move + 1); }
  /** Whether the moves \p i and \p j cross as seen along the normal of the first point of \p i. */
  bool cross(std::size_t i, std::size_t j) const;

  /** Call \p visit(pair) for move \p i, no lift, with all later moves that come within \p reach mm of it and those within the margin for
   *  crossings; for some more than once, and for some that are farther away. */
  template <typename Visit>
  void forLater(std::size_t i, double reach, Visit visit) const
  {
    const Eigen::Vector3d &start = path_[i], &finish = path_[i + 1], left = leftOf(i);
    const Eigen::Vector3d low = start.cwiseMin(finish), high = start.cwiseMax(finish), margin = Eigen::Vector3d::Constant(margin_),
                          wide = Eigen::Vector3d::Constant(std::max(margin_, reach));
    cells_->forBuckets(low - wide, high + wide, low - margin, high + margin,
                       [&](const std::uint32_t* first, const std::uint32_t* last, bool is_beside) {
                         while (last != first && *--last > i)
                           visit(MovePair{i, *last, left.dot(path_[*last] - start), left.dot(path_[*last + 1] - start), is_beside});
                       });
  }
  /** Along the surface, at right angles to move \p i, as long as it where the normal is. */
  Eigen::Vector3d leftOf(std::size_t i) const { return normals_[i].cross(path_[i + 1] - path_[i]); }

private:
  const Polyline& path_;
  const std::vector<Eigen::Vector3d>& normals_;
  const std::vector<std::size_t>& passes_;
  double slack_, margin_ = 0.0;
  std::unique_ptr<MoveCells> cells_; ///< null if no move has a length
};

} // namespace pcl_spiral
