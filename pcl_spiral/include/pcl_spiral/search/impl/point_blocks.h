// SPDX-License-Identifier: BSD-3-Clause
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

  void extend(const float* p)
  {
    for (int d = 0; d < 3; ++d) {
      low[d] = std::min(low[d], p[d]);
      high[d] = std::max(high[d], p[d]);
    }
  }
  void extend(const Box& other)
  {
    for (int d = 0; d < 3; ++d) {
      low[d] = std::min(low[d], other.low[d]);
      high[d] = std::max(high[d], other.high[d]);
    }
  }
  float squaredDistance(const Box& other) const
  {
    float sum = 0.0f;
    for (int d = 0; d < 3; ++d) {
      const float gap = std::max(std::max(low[d] - other.high[d], other.low[d] - high[d]), 0.0f);
      sum += gap * gap;
    }
    return sum;
  }
  float squaredDistance(const float* p) const
  {
    float sum = 0.0f;
    for (int d = 0; d < 3; ++d) {
      const float gap = std::max(std::max(low[d] - p[d], p[d] - high[d]), 0.0f);
      sum += gap * gap;
    }
    return sum;
  }
  float diagonal() const
  {
    float sum = 0.0f;
    for (int d = 0; d < 3; ++d)
      sum += (high[d] - low[d]) * (high[d] - low[d]);
    return std::sqrt(sum);
  }
};

/** A position, and its index before sorting. */
struct IndexedPosition {
  float x, y, z;
  std::uint32_t index;
};

/** A range of items cut into 2^n blocks of sizes as equal as possible, at most block_size each. */
class BlockPartition {
public:
  static constexpr std::size_t block_size = 32;

  explicit BlockPartition(std::size_t items = 0) : items_(items)
  {
    while (block_size << halvings_ < items)
      ++halvings_;
  }
  std::size_t blocks() const { return items_ > 0 ? std::size_t(1) << halvings_ : 0; }
  /** First item of a block; for the block past the last, the number of items. */
  std::size_t begin(std::size_t block) const { return block * items_ >> halvings_; }
  int halvings() const { return halvings_; }

private:
  std::size_t items_;
  int halvings_ = 0;
};

/** Sort positions into spatial order: halve them repeatedly across the longest side of their box, into the blocks of a
 *  BlockPartition. The order depends only on the set of positions, not on their input order or on the number of
 *  threads.
 */
void sortSpatially(std::vector<IndexedPosition>& positions);

/** Points in spatial order with the boxes of their blocks; the tree is implicit (node i has children 2i, 2i+1). */
class PointBlocks {
public:
  static constexpr std::size_t block_size = BlockPartition::block_size; ///< at most

  PointBlocks() = default;
  explicit PointBlocks(std::vector<Eigen::Vector3f> points);
  /** Blocks of points that keep their order, which must be that of blocks already, as the feet of the points of other blocks have. */
  static PointBlocks inOrder(std::vector<Eigen::Vector3f> points);

  std::size_t size() const { return points_.size(); }
  const Eigen::Vector3f& point(std::size_t i) const { return points_[i]; }
  Eigen::Vector3d position(std::size_t i) const { return points_[i].cast<double>(); }
  const std::vector<Eigen::Vector3f>& points() const { return points_; }
  /** Index of point \p i in the cloud that the blocks were made from. */
  std::uint32_t originalIndex(std::size_t i) const { return original_[i]; }

  std::size_t blockCount() const { return partition_.blocks(); }
  std::size_t blockBegin(std::size_t block) const { return partition_.begin(block); }
  std::size_t blockEnd(std::size_t block) const { return partition_.begin(block + 1); }
  const Box& blockBox(std::size_t block) const { return boxes_[blockCount() + block]; }
  const Box& box() const { return boxes_[1]; }
  /** Median diagonal of the blocks' boxes. Far larger boxes contain points far from the others. */
  float usualDiagonal() const { return usual_diagonal_; }

  /** Call \p visit(block) for every block under boxes that all pass \p keep(box), in a fixed order. */
  template <typename Keep, typename Visit>
  void forBlocks(Keep keep, Visit visit) const
  {
    const std::size_t leaves = blockCount();
    std::array<std::uint32_t, 64> stack;
    std::size_t top = 0;
    if (leaves > 0)
      stack[top++] = 1;
    while (top > 0) {
      const std::uint32_t node = stack[--top];
      if (!keep(boxes_[node]))
        continue;
      if (node >= leaves) {
        visit(node - leaves);
        continue;
      }
      stack[top++] = 2 * node + 1;
      stack[top++] = 2 * node;
    }
  }

  /** Call \p visit(block) for every block whose box is within sqrt(squared_radius) of \p query. */
  template <typename Visit>
  void forBlocksNear(const Box& query, float squared_radius, Visit visit) const
  {
    forBlocks([&](const Box& box) { return box.squaredDistance(query) <= squared_radius; }, visit);
  }

  /** The point nearest to \p query, by exact search. */
  std::uint32_t nearest(const Eigen::Vector3d& query) const;

private:
  void sort();
  void findBoxes();

  std::vector<Eigen::Vector3f> points_;
  std::vector<std::uint32_t> original_;
  std::vector<Box> boxes_;
  BlockPartition partition_;
  float usual_diagonal_ = 0.0f;
};

} // namespace pcl_spiral
