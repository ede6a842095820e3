#include "nested_cells.h"

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

/** A box about all but a few of the points: those far from the others must not decide how fine cells can be. */
Box
boxOfMost(const std::vector<Eigen::Vector3f>& points)
{
  constexpr std::size_t sampled = 10000, left_out = 1000; // one in so many, at either end
  const std::size_t step = std::max<std::size_t>(1, points.size() / sampled);
  Box box;
  std::vector<float> sample;
  for (int d = 0; d < 3; ++d) {
    sample.clear();
    for (std::size_t i = 0; i < points.size(); i += step)
      sample.push_back(points[i][d]);
    std::sort(sample.begin(), sample.end());
    const std::size_t few = sample.size() / left_out;
    const float low = sample[few], high = sample[sample.size() - 1 - few];
    box.low[d] = low - (high - low);
    box.high[d] = high + (high - low);
  }
  return box;
}

double
widthOf(const Box& box)
{
  double width = 0.0;
  for (int d = 0; d < 3; ++d)
    width = std::max(width, static_cast<double>(box.high[d]) - box.low[d]);
  return width > 0.0 ? width : 1.0;
}

} // namespace

/** The bits of \p x with two zeros between each and the next. */
std::uint64_t
NestedCells::interleaved(std::uint64_t x)
{
  x = (x | x << 32) & 0x001f00000000ffffu;
  x = (x | x << 16) & 0x001f0000ff0000ffu;
  x = (x | x << 8) & 0x100f00f00f00f00fu;
  x = (x | x << 4) & 0x10c30c30c30c30c3u;
  return (x | x << 2) & 0x1249249249249249u;
}

std::uint64_t
NestedCells::quantised(float x, int d) const
{
  // What lies outside goes to the nearest cell: no two points get farther apart by that.
  return static_cast<std::uint64_t>(std::clamp((static_cast<double>(x) - low_[d]) / unit_, 0.0, largest));
}

std::uint64_t
NestedCells::codeOf(const Eigen::Vector3f& p) const
{
  return interleaved(quantised(p.x(), 0)) << 2 | interleaved(quantised(p.y(), 1)) << 1 | interleaved(quantised(p.z(), 2));
}

NestedCells::NestedCells(const std::vector<Eigen::Vector3f>& points, std::size_t wanted)
{
  const Box box = boxOfMost(points);
  low_ = {box.low[0], box.low[1], box.low[2]};
  unit_ = widthOf(box) / largest;
  parts_ = HashParts(points, [&](const Eigen::Vector3f& p) { return codeOf(p) << 1; });
  std::vector<std::array<std::size_t, bits + 1>> counts(parts_.count());
#pragma omp parallel for schedule(dynamic, 1)
  for (std::int64_t p = 0; p < static_cast<std::int64_t>(parts_.count()); ++p)
    sortPart(p, counts[p]);
  const auto cellsAt = [&](int shift) {
    std::size_t cells = 0;
    for (const auto& count : counts)
      cells += count[shift];
    return cells;
  };
  usable_ = cellsAt(0) * wanted > points.size();
  while (shift_ < bits && cellsAt(shift_) * wanted > points.size())
    ++shift_;
  // Parts are cells too, larger ones.
  usable_ = usable_ && (std::size_t(1) << 3 * (bits - shift_)) >= parts_.count();
  if (!usable_)
    return;
  const IndexedPosition* const all = parts_.begin(0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::uint64_t code = codeOf({all[i].x, all[i].y, all[i].z}) >> 3 * shift_;
    if (!codes_.empty() && codes_.back() == code)
      continue;
    codes_.push_back(code);
    begins_.push_back(static_cast<std::uint32_t>(i));
  }
  begins_.push_back(static_cast<std::uint32_t>(points.size()));
  table_.reset(codes_.size());
  for (const std::uint64_t code : codes_)
    table_.number(mixed(code), [](std::uint32_t) { return false; });
}

/** Order a part; number of its cells of every edge. */
void
NestedCells::sortPart(std::size_t part, std::array<std::size_t, bits + 1>& cells)
{
  IndexedPosition* const begin = parts_.begin(part);
  const auto count = static_cast<std::size_t>(parts_.end(part) - begin);
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys(count);
  for (std::size_t i = 0; i < count; ++i)
    keys[i] = {codeOf({begin[i].x, begin[i].y, begin[i].z}), static_cast<std::uint32_t>(i)};
  std::sort(keys.begin(), keys.end());
  const std::vector<IndexedPosition> copy(begin, begin + count);
  for (std::size_t i = 0; i < count; ++i)
    begin[i] = copy[keys[i].second];
  cells.fill(count > 0 ? 1 : 0);
  for (std::size_t i = 1; i < count; ++i)
    for (int shift = 0; shift <= bits && keys[i].first >> 3 * shift != keys[i - 1].first >> 3 * shift; ++shift)
      ++cells[shift];
}

std::optional<std::pair<std::size_t, std::size_t>>
NestedCells::runOf(std::uint64_t code, int up) const
{
  if (up == 0) {
    const std::uint32_t cell = table_.find(mixed(code), [&](std::uint32_t number) { return codes_[number] == code; });
    if (cell == KeyTable::none)
      return std::nullopt;
    return std::pair<std::size_t, std::size_t>(cell, cell + 1);
  }
  const auto first = std::lower_bound(codes_.begin(), codes_.end(), code << 3 * up);
  const auto last = std::lower_bound(first, codes_.end(), (code + 1) << 3 * up);
  if (first == last)
    return std::nullopt;
  return std::pair<std::size_t, std::size_t>(first - codes_.begin(), last - codes_.begin());
}

} // namespace pcl_spiral
