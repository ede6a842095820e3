/** \file
 *  Points in spatial order, in blocks of 32 under an implicit tree of boxes.
 */
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Axis-parallel box. */
struct Box {
  std::array<float, 3> low{1e30f, 1e30f, 1e30f};
  std::array<float, 3> high{-1e30f, -1e30f, -1e30f};

  void
  extend(const float* p)
  {
    for (int d = 0; d < 3; ++d) {
      low[d] = std::min(low[d], p[d]);
      high[d] = std::max(high[d], p[d]);
    }
  }
  void
  extend(const Box& other)
  {
    for (int d = 0; d < 3; ++d) {
      low[d] = std::min(low[d], other.low[d]);
      high[d] = std::max(high[d], other.high[d]);
    }
  }
  float
  squaredDistance(const Box& other) const
  {
    float sum = 0.0f;
    for (int d = 0; d < 3; ++d) {
      const float gap = std::max(0.0f, std::max(low[d] - other.high[d], other.low[d] - high[d]));
      sum += gap * gap;
    }
    return sum;
  }
  float
  squaredDistance(const float* p) const
  {
    float sum = 0.0f;
    for (int d = 0; d < 3; ++d) {
      const float gap = std::max(0.0f, std::max(low[d] - p[d], p[d] - high[d]));
      sum += gap * gap;
    }
    return sum;
  }
  float
  diagonal() const
  {
    float sum = 0.0f;
    for (int d = 0; d < 3; ++d)
      sum += (high[d] - low[d]) * (high[d] - low[d]);
    return std::sqrt(sum);
  }
};

/** A position and where it stood before it was put in order. */
struct IndexedPosition {
  float x, y, z;
  std::uint32_t index;
};

/** Put positions in spatial order: halved again and again across the longest side of their box, into runs of 32.
 *  The order depends on the set of positions alone, not on the order they come in, nor on the number of threads.
 */
void
sortSpatially(std::vector<IndexedPosition>& positions);

/** Points in spatial order with the boxes of their blocks; the tree is implicit (node i has children 2i, 2i+1). */
class PointBlocks {
public:
  static constexpr std::size_t block_size = 32;

  PointBlocks() = default;
  explicit PointBlocks(const std::vector<Eigen::Vector3f>& points);

  std::size_t size() const { return points_.size(); }
  const Eigen::Vector3f& point(std::size_t i) const { return points_[i]; }
  Eigen::Vector3d position(std::size_t i) const { return points_[i].cast<double>(); }
  const std::vector<Eigen::Vector3f>& points() const { return points_; }
  /** Where point \p i stood in the cloud the blocks were made from. */
  std::uint32_t originalIndex(std::size_t i) const { return original_[i]; }

  std::size_t blockCount() const { return (points_.size() + block_size - 1) / block_size; }
  std::size_t blockBegin(std::size_t block) const { return block * block_size; }
  std::size_t blockEnd(std::size_t block) const { return std::min(points_.size(), (block + 1) * block_size); }
  const Box& blockBox(std::size_t block) const { return boxes_[leaves_ + block]; }
  const Box& box() const { return boxes_[1]; }

  /** Call \p visit(block) for every block whose box is within sqrt(squared_radius) of \p query. */
  template <typename Visit>
  void
  forBlocksNear(const Box& query, float squared_radius, Visit visit) const
  {
    std::array<std::uint32_t, 64> stack;
    std::size_t top = 0;
    stack[top++] = 1;
    while (top > 0) {
      const std::uint32_t node = stack[--top];
      if (boxes_[node].squaredDistance(query) > squared_radius)
        continue;
      if (node >= leaves_) {
        visit(node - leaves_);
        continue;
      }
      stack[top++] = 2 * node + 1;
      stack[top++] = 2 * node;
    }
  }

  /** The point nearest to \p query, by exact search. */
  std::uint32_t nearest(const Eigen::Vector3d& query) const;

private:
  std::vector<Eigen::Vector3f> points_;
  std::vector<std::uint32_t> original_;
  std::vector<Box> boxes_;
  std::size_t leaves_ = 1;
};

} // namespace pcl_spiral
