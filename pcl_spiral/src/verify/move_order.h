// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The moves of a path near a ray, in the order in which they are made.
 */
#pragma once

#include <pcl_spiral/core/polyline.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** Boxes about runs of moves that follow each other, halved as the path is, so that a search meets them in their order. The polyline must
 *  outlive it. Memory: about 12 bytes a move. */
class MoveOrder {
public:
  explicit MoveOrder(const Polyline& line);

  /** Calls \p test(move) for the moves within \p radius() of \p p, and for some others, in their order; the radius may shrink during the
   *  search. Ends when \p test returns false. */
  template <typename Radius, typename Test>
  void search(const Eigen::Vector3d& p, const Radius& radius, const Test& test) const
  {
    if (!boxes_.empty())
      searchNode(0, 0, runs_, p.cast<float>(), radius, test);
  }

private:
  static constexpr std::size_t run = 8; ///< moves in a box of the lowest level

  template <typename Radius, typename Test>
  bool searchNode(std::size_t node, std::size_t first, std::size_t count, const Eigen::Vector3f& p, const Radius& radius,
                  const Test& test) const
  {
    const double reach = radius() * (1.0 + 1e-6) + slack_;
    if (boxes_[node].squaredExteriorDistance(p) > reach * reach)
      return true;
    if (count == 1) {
      for (std::size_t move = first * run; move < std::min(moves_, (first + 1) * run); ++move)
        if (!test(move))
          return false;
      return true;
    }
    const std::size_t half = count / 2; // the first child follows its parent, the second the tree of the first
    return searchNode(node + 1, first, half, p, radius, test) && searchNode(node + 2 * half, first + half, count - half, p, radius, test);
  }
  void build(const Polyline& line, std::size_t node, std::size_t first, std::size_t count);

  std::size_t moves_ = 0, runs_ = 0;
  double slack_ = 0.0; ///< of single precision, mm
  std::vector<Eigen::AlignedBox3f> boxes_;
};

} // namespace pcl_spiral
