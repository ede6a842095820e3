// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The moves of a path in a tree of boxes.
 */
#pragma once

#include <pcl_spiral/core/polyline.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl_spiral {

/** The segments of a polyline, in groups of four that follow each other; the groups are halved repeatedly across the longest side
 * of their box, under boxes in single precision that are rounded outwards. Segments much longer than the mean are stored in pieces.
 * The polyline must outlive the index and must not change. Memory: 18 bytes per segment, at most half as much
 * again, in addition to the polyline, and 20 more while it is made.
 */
class MoveIndex {
public:
  /** \throw std::length_error for more than 2^29 segments */
  explicit MoveIndex(const Polyline& line);

  std::size_t moves() const { return line_.size() < 2 ? 0 : line_.size() - 1; }

  /** The point of the segments nearest to \p p, if it is nearer than \p distance, which then becomes its distance. */
  bool nearest(const Eigen::Vector3d& p, double& distance, Eigen::Vector3d& point) const;

  /** Call \p test(move) for every segment within \p radius() of \p p, the nearest boxes first, and for those of its group. The radius
   * may shrink during the search. A segment may be passed several times. */
  template <typename Radius, typename Test>
  void search(const Eigen::Vector3d& p, const Radius& radius, const Test& test) const
  {
    if (boxes_.empty())
      return;
    struct Entry {
      std::uint32_t node;
      float distance;
    };
    std::array<Entry, 64> stack;
    std::size_t top = 0;
    Eigen::Array4f q = Eigen::Array4f::Zero();
    q.head<3>() = (p - origin_).cast<float>();
    float limit = squared(radius());
    stack[top++] = {0, squaredDistance(boxes_[0], q)};
    while (top > 0) {
      const Entry entry = stack[--top];
      if (entry.distance > limit)
        continue;
      const std::uint32_t next = next_[entry.node];
      if (next & leaf_mark) {
        for (std::uint32_t move = next & first_mask, last = move + (next >> count_shift & 3u); move <= last; ++move)
          test(static_cast<std::size_t>(move));
        limit = squared(radius());
        continue;
      }
      Entry near{next, squaredDistance(boxes_[next], q)};
      Entry far{next + 1, squaredDistance(boxes_[next + 1], q)};
      if (far.distance < near.distance)
        std::swap(near, far);
      if (far.distance <= limit)
        stack[top++] = far;
      if (near.distance <= limit)
        stack[top++] = near;
    }
  }

private:
  /** What next_ has of a leaf: this mark, its number of moves less one, and the first of them. */
  static constexpr std::uint32_t leaf_mark = 0x80000000u, count_shift = 29, first_mask = 0x1fffffffu;

  struct alignas(16) Box4 { // relative to origin_; the fourth is 0
    std::array<float, 4> low, high;
  };
  /** Pieces that follow each other. */
  struct Group {
    Box4 box;
    std::uint32_t moves; ///< as in next_
  };

  static void extend(Box4& box, const Box4& other)
  {
    for (int d = 0; d < 3; ++d) {
      box.low[d] = std::min(box.low[d], other.low[d]);
      box.high[d] = std::max(box.high[d], other.high[d]);
    }
  }

  static float squaredDistance(const Box4& box, const Eigen::Array4f& p)
  {
    using Lanes = Eigen::Map<const Eigen::Array4f, Eigen::Aligned16>;
    const Lanes low(box.low.data()), high(box.high.data());
    return (low - p).max(p - high).max(0.0f).square().sum();
  }
  /** With a margin for the rounding of single precision. */
  float squared(double radius) const
  {
    const double wide = radius * (1.0 + 1e-6) + slack_;
    return static_cast<float>(wide * wide);
  }
  std::vector<Group> groups() const;
  void build(std::vector<Group>& groups, std::size_t first, std::size_t last, std::size_t node, std::size_t free);

  const Polyline& line_;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  double slack_ = 0.0;
  std::vector<Box4> boxes_;
  std::vector<std::uint32_t> next_; ///< of a node: its first child, the second follows; of a leaf: its moves
};

} // namespace pcl_spiral
