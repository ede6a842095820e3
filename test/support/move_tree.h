// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Linear moves in a tree of boxes: the place where a ray enters the swept ball, nearest move, overlaps.
 */
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace pcl_spiral::test {

/** The moves between consecutive points. Lengths in mm. */
class MoveTree {
public:
  explicit MoveTree(std::vector<Eigen::Vector3d> points);

  struct Entry {
    double t = 0.0;       ///< where the ray enters; the reach if it meets nothing
    std::size_t move = 0; ///< the move met
    bool met = false;
  };
  /** Smallest t in [-start, reach] at which x + t n is in the union of the capsules of \p radius round the
   * moves. */
  Entry entry(const Eigen::Vector3d& x, const Eigen::Vector3d& n, double radius, double start, double reach) const;
  /** Distance of \p p to the nearest move, and that move. */
  std::pair<double, std::size_t> nearest(const Eigen::Vector3d& p) const;
  /** Calls \p f with every move after \p move whose box overlaps the box of \p move. */
  void laterOverlaps(std::size_t move, const std::function<void(std::size_t)>& f) const;

  const std::vector<Eigen::Vector3d>& points() const { return points_; }
  std::size_t moves() const { return points_.size() - 1; }

private:
  struct Node {
    Eigen::AlignedBox3d box;
    std::uint32_t first = 0, count = 0; ///< moves of a leaf
    std::uint32_t right = 0;            ///< the left child follows its parent
  };
  std::uint32_t build(std::uint32_t first, std::uint32_t last);
  Eigen::AlignedBox3d boxOf(std::size_t move) const;

  std::vector<Eigen::Vector3d> points_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

/** Interval of the line x + t n inside the capsule of \p radius round a-b; false if the line misses it. */
bool capsuleInterval(const Eigen::Vector3d& x, const Eigen::Vector3d& n, const Eigen::Vector3d& a, const Eigen::Vector3d& b, double radius,
                     double& enter, double& leave);

} // namespace pcl_spiral::test
