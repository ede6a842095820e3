// SPDX-License-Identifier: BSD-3-Clause
#include "row_levels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

namespace pcl_spiral {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr double most_bins = 1 << 24;

/** The distance allowed between two rows, in equal bins across them. */
class AllowedDistance {
public:
  AllowedDistance(const std::vector<RowPatch>& patches, double low, double high, double floor) : low_(low), high_(high)
  {
    const double bins = std::clamp(std::ceil(8.0 * (high - low) / floor), 1.0, most_bins);
    width_ = (high - low) / bins;
    most_.assign(static_cast<std::size_t>(bins), unlimited);
    enter(patches, floor);
  }

  /** The farthest row from one at \p from such that all bins between allow their distance, times \p share; at most
   * the end. It does not come closer as \p from grows, so going as far as possible each time makes the fewest
   * rows. */
  double farthest(double from, double share) const
  {
    double most = unlimited;
    for (std::size_t bin = binOf(from); bin < most_.size(); ++bin) {
      most = std::min(most, share * most_[bin]);
      const double begin = low_ + static_cast<double>(bin) * width_;
      if (from + most <= begin)
        return begin;
      if (from + most < begin + width_)
        return from + most;
    }
    return high_;
  }

  /** The rows if each takes up the \p share of what is allowed; one more than \p limit if these are not
   * enough. */
  std::vector<double> rows(double share, std::size_t limit) const
  {
    const double end = high_ - 1e-9 * (high_ - low_);
    std::vector<double> levels{farthest(low_, 0.5 * share)};
    while (levels.size() <= limit && farthest(levels.back(), 0.5 * share) < end)
      levels.push_back(farthest(levels.back(), share));
    return levels;
  }

private:
  std::size_t binOf(double x) const
  {
    return static_cast<std::size_t>(std::clamp((x - low_) / width_, 0.0, static_cast<double>(most_.size() - 1)));
  }

  /** Narrowest first, so that each bin is set only once. */
  void enter(const std::vector<RowPatch>& patches, double floor)
  {
    std::vector<std::size_t> order, open(most_.size() + 1);
    for (std::size_t i = 0; i < patches.size(); ++i)
      if (patches[i].most < unlimited && patches[i].high >= low_ && patches[i].low <= high_)
        order.push_back(i);
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return patches[a].most < patches[b].most || (patches[a].most == patches[b].most && a < b);
    });
    std::iota(open.begin(), open.end(), std::size_t{0}); // for each bin, the next empty one
    const auto nextOpen = [&](std::size_t bin) {
      for (; open[bin] != bin; bin = open[bin])
        open[bin] = open[open[bin]];
      return bin;
    };
    for (const std::size_t i : order)
      for (std::size_t bin = nextOpen(binOf(patches[i].low)), last = binOf(patches[i].high); bin <= last; bin = nextOpen(bin)) {
        most_[bin] = std::max(patches[i].most, floor);
        open[bin] = bin + 1;
      }
  }

  double low_, high_, width_ = 0.0;
  std::vector<double> most_;
};

/** As many rows as needed. The distance left over is shared among them. */
std::vector<double>
evenRows(const AllowedDistance& allowed)
{
  constexpr int halvings = 40;
  const std::size_t count = allowed.rows(1.0, RowLevels::none - 1).size();
  double low = 0.0, high = 1.0;
  for (int i = 0; i < halvings; ++i) {
    const double share = 0.5 * (low + high);
    (allowed.rows(share, count).size() <= count ? high : low) = share;
  }
  return allowed.rows(high, count);
}

void
findHeld(const std::vector<RowPatch>& patches, double floor, RowLevels& rows)
{
  double area = 0.0, held = 0.0;
  for (std::size_t i = 0; i < patches.size(); ++i) {
    area += patches[i].area;
    if (!(patches[i].most < floor))
      continue;
    held += patches[i].area;
    if (rows.narrowest == RowLevels::none || patches[i].most < patches[rows.narrowest].most)
      rows.narrowest = i;
  }
  rows.held_share = area > 0.0 ? held / area : 0.0;
}

} // namespace

RowLevels
rowLevels(const std::vector<RowPatch>& patches, double low, double high, double floor)
{
  RowLevels rows;
  findHeld(patches, floor, rows);
  rows.levels = !(high > low) ? std::vector<double>{low} : evenRows(AllowedDistance(patches, low, high, floor));
  for (std::size_t k = 0; k + 1 < rows.levels.size(); ++k) {
    const double step = rows.levels[k + 1] - rows.levels[k];
    rows.smallest_step = k == 0 ? step : std::min(rows.smallest_step, step);
    rows.largest_step = std::max(rows.largest_step, step);
  }
  return rows;
}

} // namespace pcl_spiral
