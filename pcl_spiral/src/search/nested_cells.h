/** \file
 *  Points in cubic cells within cells, for neighbours among which a few lie far off the surface. Private to search.
 */
#pragma once

#include "hash_parts.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace pcl_spiral {

/** Points in the order of their cells along a Morton curve, on which every cell of twice, four times... the edge is a run too.
 *
 *  A tree of boxes that halves points suffers from outliers: they stretch its boxes across the surface. Cells do not.
 */
class NestedCells {
public:
  /** Cells of the edge at which those that hold points hold at least \p wanted on average. */
  NestedCells(const std::vector<Eigen::Vector3f>& points, std::size_t wanted);

  /** False where the points lie too unevenly for cells. */
  bool usable() const { return usable_; }
  std::size_t cellCount() const { return codes_.size(); }
  const IndexedPosition* begin(std::size_t cell) const { return parts_.begin(0) + begins_[cell]; }
  const IndexedPosition* end(std::size_t cell) const { return parts_.begin(0) + begins_[cell + 1]; }
  /** Cells of 2^\p up times the edge up to this hold everything. */
  int highest() const { return bits - shift_; }
  double edge(int up) const { return unit_ * static_cast<double>(std::uint64_t(1) << (shift_ + up)); }

  /** Call \p visit(first, last) for the runs of points in the cell of 2^\p up times the edge about \p p, and in the 26 about
   *  that: all within one such edge of \p p are among them. */
  template <typename Visit>
  void
  forRunsAbout(const IndexedPosition& p, int up, Visit visit) const
  {
    const int shift = shift_ + up;
    const auto last = static_cast<std::int64_t>(((std::uint64_t(1) << bits) - 1) >> shift);
    std::array<std::int64_t, 3> at;
    for (int d = 0; d < 3; ++d)
      at[d] = static_cast<std::int64_t>(quantised((&p.x)[d], d) >> shift);
    for (std::int64_t x = std::max<std::int64_t>(0, at[0] - 1); x <= std::min(last, at[0] + 1); ++x)
      for (std::int64_t y = std::max<std::int64_t>(0, at[1] - 1); y <= std::min(last, at[1] + 1); ++y)
        for (std::int64_t z = std::max<std::int64_t>(0, at[2] - 1); z <= std::min(last, at[2] + 1); ++z)
          if (const auto run = runOf(interleaved(x) << 2 | interleaved(y) << 1 | interleaved(z), up))
            visit(begin(run->first), begin(run->second));
  }

private:
  static constexpr int bits = 21; // a coordinate
  static constexpr double largest = (1 << bits) - 1;

  static std::uint64_t interleaved(std::uint64_t x);
  std::uint64_t quantised(float x, int d) const;
  std::uint64_t codeOf(const Eigen::Vector3f& p) const;
  /** The cells in a cell of 2^up times the edge: from the first to before the second. */
  std::optional<std::pair<std::size_t, std::size_t>> runOf(std::uint64_t code, int up) const;
  void sortPart(std::size_t part, std::array<std::size_t, bits + 1>& cells);

  Eigen::Vector3d low_ = Eigen::Vector3d::Zero();
  double unit_ = 1.0; ///< edge of the smallest cells there could be
  HashParts parts_;
  int shift_ = 0; ///< cells are 2^shift_ units wide
  bool usable_ = true;
  std::vector<std::uint64_t> codes_; ///< of the cells, ascending
  std::vector<std::uint32_t> begins_;
  KeyTable table_;
};

} // namespace pcl_spiral
