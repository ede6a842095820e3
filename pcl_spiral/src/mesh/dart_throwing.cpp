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
    order_.resize(darts.size());
#pragma omp parallel for schedule(static)
    for (std::int64_t i = 0; i < static_cast<std::int64_t>(darts.size()); ++i)
      order_[i] = {keyOf(darts[i].position), darts[i].priority, static_cast<std::uint32_t>(i)};
    std::sort(order_.begin(), order_.end(), [&](const Placed& a, const Placed& b) {
      if (a.key != b.key || a.priority != b.priority)
        return std::tie(a.key, a.priority) < std::tie(b.key, b.priority);
      const Eigen::Vector3f &p = darts[a.index].position, &q = darts[b.index].position;
      return std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3);
    });
    for (std::size_t k = 0; k < order_.size(); ++k)
      if (k == 0 || order_[k].key != order_[k - 1].key) {
        keys_.push_back(order_[k].key);
        begin_.push_back(static_cast<std::uint32_t>(k));
      }
    begin_.push_back(static_cast<std::uint32_t>(order_.size()));
    taken_.assign(order_.size(), 0);
    for (std::size_t k = 0; k < order_.size(); ++k)
      taken_[k] = order_[k].priority == 0;
  }

  /** Take what can be in all cells, those of one colour, two apart, at the same time. */
  void
  fill()
  {
    std::array<std::vector<std::uint32_t>, 8> colours;
    for (std::uint32_t c = 0; c < keys_.size(); ++c)
      colours[(keys_[c] & 1) | (keys_[c] >> key_bits & 1) << 1 | (keys_[c] >> 2 * key_bits & 1) << 2].push_back(c);
    for (const std::vector<std::uint32_t>& cells : colours) {
#pragma omp parallel for schedule(dynamic, 256)
      for (std::int64_t i = 0; i < static_cast<std::int64_t>(cells.size()); ++i)
        fillCell(cells[i]);
    }
  }

  std::vector<std::uint32_t>
  taken() const
  {
    std::vector<std::uint32_t> result;
    for (std::size_t k = 0; k < order_.size(); ++k)
      if (taken_[k])
        result.push_back(order_[k].index);
    return result;
  }

private:
  std::uint64_t
  keyOf(const Eigen::Vector3f& p) const
  {
    const auto cell = [&](int d) { return static_cast<std::uint64_t>((p[d] - low_[d]) / edge_) + 1; };
    return cell(0) << 2 * key_bits | cell(1) << key_bits | cell(2);
  }

  void
  fillCell(std::uint32_t c)
  {
    std::array<std::pair<std::uint32_t, std::uint32_t>, 9> near; // cells that follow one another along z
    int runs = 0;
    for (int dx = -1; dx <= 1; ++dx)
      for (int dy = -1; dy <= 1; ++dy) {
        const std::uint64_t middle = keys_[c] + (static_cast<std::uint64_t>(dx) << 2 * key_bits) + (static_cast<std::uint64_t>(dy) << key_bits);
        const auto first = std::lower_bound(keys_.begin(), keys_.end(), middle - 1) - keys_.begin();
        auto last = first;
        while (last < static_cast<std::ptrdiff_t>(keys_.size()) && keys_[last] <= middle + 1)
          ++last;
        if (last > first)
          near[runs++] = {begin_[first], begin_[last]};
      }
    const float squared = edge_ * edge_;
    for (std::uint32_t k = begin_[c]; k < begin_[c + 1]; ++k) {
      const Eigen::Vector3f& p = darts_[order_[k].index].position;
      bool free = !taken_[k];
      for (int r = 0; free && r < runs; ++r)
        for (std::uint32_t j = near[r].first; free && j < near[r].second; ++j)
          free = !taken_[j] || !((darts_[order_[j].index].position - p).squaredNorm() < squared);
      if (free)
        taken_[k] = 1;
    }
  }

  const std::vector<Dart>& darts_;
  float edge_;
  Eigen::Array3f low_;
  std::vector<Placed> order_;
  std::vector<std::uint64_t> keys_; ///< of the cells with darts, ascending
  std::vector<std::uint32_t> begin_;
  std::vector<std::uint8_t> taken_;
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
