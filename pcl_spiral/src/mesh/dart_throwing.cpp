// SPDX-License-Identifier: BSD-3-Clause
#include "dart_throwing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace pcl_spiral {
namespace {

constexpr int key_bits = 21; // of each coordinate of a cell

/** A dart in its cell. */
struct Placed {
  std::uint64_t key;
  std::uint32_t priority, index;
};

/** Darts in the order of their cells and, in each, of their priorities. */
class DartGrid {
public:
  DartGrid(const std::vector<Dart>& darts, double distance) : darts_(darts), edge_(static_cast<float>(distance))
  {
    low_.setConstant(1e30f);
    for (const Dart& dart : darts)
      low_ = low_.min(dart.position.array());
    sort();
    for (std::size_t k = 0; k < order_.size(); ++k)
      if (k == 0 || order_[k].key != order_[k - 1].key) {
        keys_.push_back(order_[k].key);
        begin_.push_back(static_cast<std::uint32_t>(k));
      }
    begin_.push_back(static_cast<std::uint32_t>(order_.size()));
    taken_.assign(keys_.size(), 0);
    for (std::size_t c = 0; c < keys_.size(); ++c)
      while (begin_[c] + taken_[c] < begin_[c + 1] && order_[begin_[c] + taken_[c]].priority == 0)
        ++taken_[c];
  }

  /** Take what can be taken in all cells; cells of one colour, two apart, at the same time. */
  void fill()
  {
    std::array<std::vector<std::uint32_t>, 8> colours;
    for (std::uint32_t c = 0; c < keys_.size(); ++c)
      colours[(keys_[c] & 1) | (keys_[c] >> key_bits & 1) << 1 | (keys_[c] >> 2 * key_bits & 1) << 2].push_back(c);
    for (const std::vector<std::uint32_t>& cells : colours) {
#pragma omp parallel
      {
        std::vector<Eigen::Vector3f> near;
#pragma omp for schedule(dynamic, 256)
        for (std::int64_t i = 0; i < static_cast<std::int64_t>(cells.size()); ++i)
          fillCell(cells[i], near);
      }
    }
  }

  std::vector<std::uint32_t> taken() const
  {
    std::vector<std::uint32_t> result;
    for (std::size_t c = 0; c < keys_.size(); ++c)
      for (std::uint32_t k = 0; k < taken_[c]; ++k)
        result.push_back(order_[begin_[c] + k].index);
    return result;
  }

private:
  std::uint64_t keyOf(const Eigen::Vector3f& p) const
  {
    const auto cell = [&](int d) { return static_cast<std::uint64_t>((p[d] - low_[d]) / edge_) + 1; };
    return cell(0) << 2 * key_bits | cell(1) << key_bits | cell(2);
  }

  bool isBefore(const Placed& a, const Placed& b) const
  {
    if (a.key != b.key || a.priority != b.priority)
      return std::tie(a.key, a.priority) < std::tie(b.key, b.priority);
    const Eigen::Vector3f &p = darts_[a.index].position, &q = darts_[b.index].position;
    return std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3);
  }

  /** Put all darts in order: first in parts, which are then merged in pairs. */
  void sort()
  {
    constexpr std::int64_t parts = 16;
    const auto n = static_cast<std::int64_t>(darts_.size());
    const auto before = [this](const Placed& a, const Placed& b) { return isBefore(a, b); };
    const auto at = [&](std::int64_t part) { return order_.begin() + n * part / parts; };
    order_.resize(darts_.size());
#pragma omp parallel for schedule(dynamic, 1)
    for (std::int64_t part = 0; part < parts; ++part) {
      for (std::int64_t i = n * part / parts; i < n * (part + 1) / parts; ++i)
        order_[i] = {keyOf(darts_[i].position), darts_[i].priority, static_cast<std::uint32_t>(i)};
      std::sort(at(part), at(part + 1), before);
    }
    for (std::int64_t width = 1; width < parts; width *= 2) {
#pragma omp parallel for schedule(dynamic, 1)
      for (std::int64_t part = 0; part < parts; part += 2 * width)
        std::inplace_merge(at(part), at(part + width), at(part + 2 * width), before);
    }
  }

  /** Places taken in cell \p c and the cells around it. */
  void lookAround(std::uint32_t c, std::vector<Eigen::Vector3f>& near) const
  {
    near.clear();
    for (int dx = -1; dx <= 1; ++dx)
      for (int dy = -1; dy <= 1; ++dy) { // cells along z follow one another
        const std::uint64_t middle =
            keys_[c] + (static_cast<std::uint64_t>(dx) << 2 * key_bits) + (static_cast<std::uint64_t>(dy) << key_bits);
        const auto first = std::lower_bound(keys_.begin(), keys_.end(), middle - 1) - keys_.begin();
        for (auto other = first; other < static_cast<std::ptrdiff_t>(keys_.size()) && keys_[other] <= middle + 1; ++other)
          for (std::uint32_t k = 0; k < taken_[other]; ++k)
            near.push_back(darts_[order_[begin_[other] + k].index].position);
      }
  }

  /** Take darts of cell \p c, and move them to its front. */
  void fillCell(std::uint32_t c, std::vector<Eigen::Vector3f>& near)
  {
    lookAround(c, near);
    const float squared = edge_ * edge_;
    for (std::uint32_t k = begin_[c] + taken_[c]; k < begin_[c + 1]; ++k) {
      const Eigen::Vector3f& p = darts_[order_[k].index].position;
      if (std::any_of(near.begin(), near.end(), [&](const Eigen::Vector3f& q) { return (q - p).squaredNorm() < squared; }))
        continue;
      near.push_back(p);
      std::swap(order_[begin_[c] + taken_[c]++], order_[k]);
    }
  }

  const std::vector<Dart>& darts_;
  float edge_;
  Eigen::Array3f low_;
  std::vector<Placed> order_;
  std::vector<std::uint64_t> keys_; ///< of the cells with darts, ascending
  std::vector<std::uint32_t> begin_;
  std::vector<std::uint32_t> taken_; ///< of each cell: number of its darts that are taken, the first ones
};

} // namespace

std::vector<std::uint32_t>
throwDarts(const std::vector<Dart>& darts, double distance)
{
  DartGrid grid(darts, distance);
  grid.fill();
  return grid.taken();
}

} // namespace pcl_spiral
