// SPDX-License-Identifier: BSD-3-Clause
#include "closed_sheets.h"

#include <algorithm>
#include <cstddef>

namespace pcl_spiral {
namespace {

constexpr double opening = 0.5; // of the radius of the ball
constexpr double apart = 3.5;   // cells from the neck between two sheets, on both sides: triangles reach over six spacings

/** The four neighbours of a node inside a grid whose outermost nodes are never asked. */
class Neighbours {
public:
  explicit Neighbours(const ClosingGrid& grid) : grid_(grid), offsets_{1, -1, grid.columns(), -grid.columns()} {}

  /** Calls \p visit for each neighbour of \p node to which the surface leads. */
  template <typename Visit>
  void forEach(std::size_t node, Visit visit) const
  {
    for (const std::int64_t offset : offsets_) {
      const std::size_t other = node + static_cast<std::size_t>(offset);
      if (grid_.has(other))
        visit(other);
    }
  }

private:
  const ClosingGrid& grid_;
  std::int64_t offsets_[4];
};

/** Squared distances, in cells, of all nodes from the nearest one that is \p marked: lower envelopes of parabolas, by columns, then by
 *  rows (Felzenszwalb and Huttenlocher 2012, Distance Transforms of Sampled Functions, algorithm 1). */
class DistanceMap {
public:
  DistanceMap(const ClosingGrid& grid, const std::vector<std::uint8_t>& marked)
  : columns_(grid.columns()), rows_(grid.rows()), squared_(marked.size())
  {
    for (std::size_t i = 0; i < marked.size(); ++i)
      squared_[i] = marked[i] != 0 ? 0.0 : far;
    along(columns_, rows_, 1, columns_);
    along(rows_, columns_, columns_, 1);
  }

  double squared(std::size_t node) const { return squared_[node]; }

private:
  static constexpr double far = 1e12;

  /** \p lines of \p count nodes, \p step apart in a line, lines \p next apart. */
  void along(std::int64_t lines, std::int64_t count, std::int64_t next, std::int64_t step)
  {
#pragma omp parallel
    {
      std::vector<double> f(static_cast<std::size_t>(count)), from(static_cast<std::size_t>(count) + 1);
      std::vector<std::int64_t> lowest(static_cast<std::size_t>(count));
#pragma omp for schedule(static)
      for (std::int64_t line = 0; line < lines; ++line) {
        double* const values = squared_.data() + line * next;
        for (std::int64_t q = 0; q < count; ++q)
          f[q] = values[q * step];
        envelope(f, from, lowest);
        std::int64_t k = 0;
        for (std::int64_t q = 0; q < count; ++q) {
          while (from[k + 1] < static_cast<double>(q))
            ++k;
          const auto off = static_cast<double>(q - lowest[k]);
          values[q * step] = off * off + f[lowest[k]];
        }
      }
    }
  }

  static void envelope(const std::vector<double>& f, std::vector<double>& from, std::vector<std::int64_t>& lowest)
  {
    const auto meet = [&](std::int64_t q, std::int64_t p) {
      const auto a = static_cast<double>(q), b = static_cast<double>(p);
      return (f[q] + a * a - f[p] - b * b) / (2.0 * (a - b));
    };
    std::int64_t k = 0;
    lowest[0] = 0;
    from[0] = -far;
    from[1] = far;
    for (std::int64_t q = 1; q < static_cast<std::int64_t>(f.size()); ++q) {
      double s = meet(q, lowest[k]);
      while (k > 0 && s <= from[k])
        s = meet(q, lowest[--k]);
      lowest[++k] = q;
      from[k] = s;
      from[k + 1] = far;
    }
  }

  std::int64_t columns_, rows_;
  std::vector<double> squared_;
};

/** The work of closedSheets. */
class Sheets {
public:
  Sheets(const ClosingGrid& grid, double radius)
  : grid_(grid), neighbours_(grid), disc_(opening * radius / grid.cell()), sheet_(grid.size(), 0)
  {}

  std::vector<std::uint32_t> find()
  {
    findCores();
    label();
    grow();
    separate();
    return std::move(sheet_);
  }

private:
  /** Nodes about which the disc of the opening lies on one sheet. */
  void findCores()
  {
    std::vector<std::uint8_t> rim(grid_.size(), 1);
    for (std::size_t i = 0; i < grid_.size(); ++i)
      if (grid_.has(i)) { // never at the edge of the grid
        int joined = 0;
        neighbours_.forEach(i, [&](std::size_t) { ++joined; });
        rim[i] = joined < 4;
      }
    const DistanceMap from_rim(grid_, rim);
    core_.resize(grid_.size());
    for (std::size_t i = 0; i < grid_.size(); ++i)
      core_[i] = from_rim.squared(i) > disc_ * disc_;
  }

  /** Numbers the connected cores. */
  void label()
  {
    std::uint32_t count = 0;
    std::vector<std::size_t> stack;
    for (std::size_t i = 0; i < grid_.size(); ++i) {
      if (core_[i] == 0 || sheet_[i] != 0)
        continue;
      sheet_[i] = ++count;
      stack.assign(1, i);
      while (!stack.empty()) {
        const std::size_t from = stack.back();
        stack.pop_back();
        neighbours_.forEach(from, [&](std::size_t other) {
          if (core_[other] == 0 || sheet_[other] != 0)
            return;
          sheet_[other] = count;
          stack.push_back(other);
        });
      }
    }
  }

  /** Gives each core its disc back. */
  void grow()
  {
    std::vector<std::size_t> front, next, seed(grid_.size());
    for (std::size_t i = 0; i < grid_.size(); ++i)
      if (sheet_[i] != 0) {
        seed[i] = i;
        front.push_back(i);
      }
    const double most = (disc_ + 1.0) * (disc_ + 1.0);
    const auto squared = [&](std::size_t a, std::size_t b) {
      const std::int64_t columns = grid_.columns(), ia = static_cast<std::int64_t>(a), ib = static_cast<std::int64_t>(b);
      const std::int64_t along = ia % columns - ib % columns, across = ia / columns - ib / columns;
      const auto du = static_cast<double>(along), dv = static_cast<double>(across);
      return du * du + dv * dv;
    };
    while (!front.empty()) {
      next.clear();
      for (const std::size_t from : front)
        neighbours_.forEach(from, [&](std::size_t other) {
          if (sheet_[other] != 0 || squared(seed[from], other) > most)
            return;
          sheet_[other] = sheet_[from];
          seed[other] = seed[from];
          next.push_back(other);
        });
      front.swap(next);
    }
  }

  /** Leaves out the necks between sheets. */
  void separate()
  {
    std::vector<std::uint8_t> neck(grid_.size(), 0);
    for (std::size_t i = 0; i < grid_.size(); ++i)
      if (sheet_[i] != 0)
        neighbours_.forEach(i, [&](std::size_t other) {
          if (sheet_[other] != 0 && sheet_[other] != sheet_[i])
            neck[i] = 1;
        });
    if (std::find(neck.begin(), neck.end(), 1) == neck.end())
      return;
    const DistanceMap from_neck(grid_, neck);
    for (std::size_t i = 0; i < grid_.size(); ++i)
      if (from_neck.squared(i) <= apart * apart)
        sheet_[i] = 0;
  }

  const ClosingGrid& grid_;
  Neighbours neighbours_;
  double disc_; ///< cells
  std::vector<std::uint8_t> core_;
  std::vector<std::uint32_t> sheet_;
};

} // namespace

std::vector<std::uint32_t>
closedSheets(const ClosingGrid& grid, double radius)
{
  return Sheets(grid, radius).find();
}

} // namespace pcl_spiral
