// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The moves of a path by the cells of a lattice.
 */
#pragma once

#include <pcl_spiral/core/polyline.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** The moves of a path by the cells that they run through. Cells share buckets through a hash: a bucket holds moves of other cells too.
 *  About twenty bytes a move of about the width of a cell. */
class MoveCells {
public:
  /** Moves i, from point i of \p path to the next, of which \p holds(i) is true. \p width: of a cell, mm. */
  template <typename Holds>
  MoveCells(const Polyline& path, const Holds& holds, double width) : width_(width), cells_a_mm_(1.0 / width)
  {
    std::size_t buckets = 1;
    while (buckets < path.size())
      buckets *= 2;
    mask_ = buckets - 1;
    std::vector<std::atomic<std::uint32_t>> ends(buckets);
    forMoves(path, holds, [&](std::size_t, std::size_t bucket) { ends[bucket].fetch_add(1, std::memory_order_relaxed); });
    begin_.resize(buckets + 1);
    std::uint32_t before = 0;
    for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
      begin_[bucket] = before;
      before += ends[bucket].load(std::memory_order_relaxed);
      ends[bucket].store(begin_[bucket], std::memory_order_relaxed);
    }
    begin_[buckets] = before;
    moves_.resize(before);
    forMoves(path, holds, [&](std::size_t move, std::size_t bucket) {
      moves_[ends[bucket].fetch_add(1, std::memory_order_relaxed)] = static_cast<std::uint32_t>(move);
    });
    const auto count = static_cast<std::int64_t>(buckets);
#pragma omp parallel for schedule(static)
    for (std::int64_t bucket = 0; bucket < count; ++bucket) // threads fill a bucket in any order
      std::sort(moves_.begin() + begin_[bucket], moves_.begin() + begin_[bucket + 1]);
  }

  /** Call \p visit(first, last, is_inner) with the moves of each bucket with a cell that the box from \p low to \p high touches, in rising
   *  order. \p is_inner: the box from \p inner_low to \p inner_high, within the other, touches the cell too. */
  template <typename Visit>
  void forBuckets(const Eigen::Vector3d& low, const Eigen::Vector3d& high, const Eigen::Vector3d& inner_low,
                  const Eigen::Vector3d& inner_high, Visit visit) const
  {
    struct Bucket {
      const std::uint32_t *first, *last;
      bool is_inner;
    };
    std::array<Bucket, 32> found; // looked up together, then visited: memory answers one while the next is asked for
    std::size_t count = 0;
    const auto visitFound = [&] {
      for (std::size_t i = 0; i < count; ++i)
        visit(found[i].first, found[i].last, found[i].is_inner);
      count = 0;
    };
    const Range inner = rangeOf(inner_low, inner_high);
    forCells(rangeOf(low, high), [&](const Cell& cell, std::size_t bucket) {
      found[count++] = {moves_.data() + begin_[bucket], moves_.data() + begin_[bucket + 1], inner.holds(cell)};
      if (count == found.size())
        visitFound();
    });
    visitFound();
  }

private:
  using Cell = std::array<std::int64_t, 3>;

  /** Cells from the first to the last along each axis. */
  struct Range {
    Cell first, last;

    bool holds(const Cell& cell) const
    {
      return cell[0] >= first[0] && cell[0] <= last[0] && cell[1] >= first[1] && cell[1] <= last[1] && cell[2] >= first[2] &&
             cell[2] <= last[2];
    }
  };

  template <typename Holds, typename Visit>
  void forMoves(const Polyline& path, const Holds& holds, Visit visit) const
  {
    const auto moves = static_cast<std::int64_t>(path.size()) - 1;
#pragma omp parallel for schedule(static)
    for (std::int64_t i = 0; i < moves; ++i) {
      if (!holds(static_cast<std::size_t>(i)))
        continue;
      const Eigen::Vector3d along = path[i + 1] - path[i];
      const int pieces = 1 + static_cast<int>(along.norm() / width_); // a long move runs through few of the cells in its box
      for (int k = 0; k < pieces; ++k) {
        const Eigen::Vector3d a = path[i] + static_cast<double>(k) / pieces * along;
        const Eigen::Vector3d b = k + 1 == pieces ? path[i + 1] : Eigen::Vector3d(path[i] + static_cast<double>(k + 1) / pieces * along);
        forCells(rangeOf(a.cwiseMin(b), a.cwiseMax(b)),
                 [&](const Cell&, std::size_t bucket) { visit(static_cast<std::size_t>(i), bucket); });
      }
    }
  }
  Range rangeOf(const Eigen::Vector3d& low, const Eigen::Vector3d& high) const
  {
    return {{cellAt(low[0]), cellAt(low[1]), cellAt(low[2])}, {cellAt(high[0]), cellAt(high[1]), cellAt(high[2])}};
  }
  template <typename Visit>
  void forCells(const Range& range, Visit visit) const
  {
    for (std::int64_t z = range.first[2]; z <= range.last[2]; ++z)
      for (std::int64_t y = range.first[1]; y <= range.last[1]; ++y)
        for (std::int64_t x = range.first[0]; x <= range.last[0]; ++x)
          visit(Cell{x, y, z},
                (static_cast<std::size_t>(x) + 73856093u * static_cast<std::size_t>(y) + 19349663u * static_cast<std::size_t>(z)) & mask_);
  }

  std::int64_t cellAt(double x) const
  {
    const double place = x * cells_a_mm_;
    const auto cell = static_cast<std::int64_t>(place);
    return cell - (static_cast<double>(cell) > place); // floor, without a call
  }

  double width_, cells_a_mm_;
  std::size_t mask_ = 0;
  std::vector<std::uint32_t> begin_, moves_; ///< moves of bucket b: from begin_[b] to begin_[b + 1]
};

} // namespace pcl_spiral
