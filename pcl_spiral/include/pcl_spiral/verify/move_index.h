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

/** The segments of a polyline, halved again and again across the longest side of their box, under boxes in single
 *  precision that are rounded outwards. Segments much longer than the mean stand in it piece by piece. Memory: 36 to 72
 *  bytes a segment beside the polyline, which must outlive the index and stay as it is.
 */
class MoveIndex {
public:
  explicit MoveIndex(const Polyline& line);

  std::size_t moves() const { return line_.size() < 2 ? 0 : line_.size() - 1; }

  /** The nearest point of the segments to \p p, when it is nearer than \p distance, which becomes its distance. */
  bool nearest(const Eigen::Vector3d& p, double& distance, Eigen::Vector3d& point) const;

  /** Call \p test(move) for every segment that comes within \p radius() of \p p, the nearest boxes first. The radius may
   *  shrink as the search goes. A segment may come twice. */
  template <typename Radius, typename Test>
  void
  search(const Eigen::Vector3d& p, const Radius& radius, const Test& test) const
  {
    if (nodes_.empty())
      return;
    struct Entry {
      std::uint32_t node;
      float distance;
    };
    std::array<Entry, 64> stack;
    std::size_t top = 0;
    const Eigen::Vector3f q = (p - origin_).cast<float>();
    float limit = squared(radius());
    stack[top++] = {0, squaredDistance(nodes_[0], q)};
    while (top > 0) {
      const Entry entry = stack[--top];
      if (entry.distance > limit)
        continue;
      const Node& node = nodes_[entry.node];
      if (node.count > 0) {
        for (std::uint32_t i = node.next; i < node.next + node.count; ++i)
          test(static_cast<std::size_t>(order_[i]));
        limit = squared(radius());
        continue;
      }
      Entry near{entry.node + 1, squaredDistance(nodes_[entry.node + 1], q)};
      Entry far{node.next, squaredDistance(nodes_[node.next], q)};
      if (far.distance < near.distance)
        std::swap(near, far);
      if (far.distance <= limit)
        stack[top++] = far;
      if (near.distance <= limit)
        stack[top++] = near;
    }
  }

private:
  struct Node {
    std::array<float, 3> low, high; ///< from origin_
    std::uint32_t next = 0;         ///< the right child (the left follows its parent), or the first entry of a leaf
    std::uint32_t count = 0;        ///< entries of a leaf, 0 inside the tree
  };
  struct Piece {
    std::array<float, 3> low, high;
    std::uint32_t move;
  };

  static float
  squaredDistance(const Node& node, const Eigen::Vector3f& p)
  {
    float sum = 0.0f;
    for (int d = 0; d < 3; ++d) {
      const float gap = std::max(0.0f, std::max(node.low[d] - p[d], p[d] - node.high[d]));
      sum += gap * gap;
    }
    return sum;
  }
  /** With room for what single precision loses. */
  float
  squared(double radius) const
  {
    const double wide = radius * (1.0 + 1e-6) + slack_;
    return static_cast<float>(wide * wide);
  }
  std::vector<Piece> pieces() const;
  std::uint32_t build(std::vector<Piece>& pieces, std::size_t first, std::size_t last);

  const Polyline& line_;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  double slack_ = 0.0;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

} // namespace pcl_spiral
