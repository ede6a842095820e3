// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/search/impl/move_index.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl_spiral {
namespace {

constexpr double longest_piece = 2.0; // in mean lengths: at most half as many pieces again as segments
constexpr std::size_t alone = 4096;   // pieces that one thread puts into boxes; only speed: the boxes are the same
constexpr std::size_t together = 4;   // pieces of a group
constexpr float rounding = 1.2e-7f;   // of a coordinate, at least the next number in single precision

} // namespace

MoveIndex::MoveIndex(const Polyline& line) : line_(line)
{
  if (line_.size() < 2)
    return;
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : line_)
    box.extend(p);
  origin_ = box.center();
  slack_ = 4e-7 * box.diagonal().norm();
  const std::vector<Piece> all = pieces();
  std::vector<Group> sorted = groups(all);
  boxes_.resize(2 * all.size() - 1);
  next_.resize(2 * all.size() - 1);
#pragma omp parallel if (all.size() > 2 * alone)
#pragma omp single
  build(sorted, 0, sorted.size(), all, 0, 1);
}

std::vector<MoveIndex::Piece>
MoveIndex::pieces() const
{
  const double limit = longest_piece * length(line_) / static_cast<double>(moves());
  const auto parts = [&](std::size_t i) {
    return limit > 0.0 ? std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil((line_[i + 1] - line_[i]).norm() / limit))) : 1;
  };
  const auto blocks = static_cast<std::int64_t>((moves() + alone - 1) / alone);
  const auto endOf = [this](std::size_t block) { return std::min(moves(), (block + 1) * alone); };
  std::vector<std::size_t> begin(blocks + 1, 0); // of each block's pieces
#pragma omp parallel for schedule(static) if (blocks > 1)
  for (std::int64_t b = 0; b < blocks; ++b)
    for (std::size_t i = b * alone; i < endOf(b); ++i)
      begin[b + 1] += parts(i);
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<Piece> result(begin.back());
#pragma omp parallel for schedule(static) if (blocks > 1)
  for (std::int64_t b = 0; b < blocks; ++b)
    for (std::size_t i = b * alone, next = begin[b]; i < endOf(b); ++i) {
      const Eigen::Vector3d a = line_[i] - origin_, d = line_[i + 1] - line_[i];
      const std::size_t count = parts(i);
      for (std::size_t k = 0; k < count; ++k, ++next) {
        const Eigen::Vector3f p = (a + d * (static_cast<double>(k) / static_cast<double>(count))).cast<float>();
        const Eigen::Vector3f q = (a + d * (static_cast<double>(k + 1) / static_cast<double>(count))).cast<float>();
        result[next].move = static_cast<std::uint32_t>(i);
        for (int axis = 0; axis < 3; ++axis) {
          const float low = std::min(p[axis], q[axis]), high = std::max(p[axis], q[axis]);
          result[next].box.low[axis] = low - rounding * std::abs(low);
          result[next].box.high[axis] = high + rounding * std::abs(high);
        }
      }
    }
  return result;
}

/** Consecutive pieces are near each other already: they stay together, and only their groups are sorted. */
std::vector<MoveIndex::Group>
MoveIndex::groups(const std::vector<Piece>& pieces)
{
  std::vector<Group> result((pieces.size() + together - 1) / together);
  const auto count = static_cast<std::int64_t>(result.size());
#pragma omp parallel for schedule(static) if (pieces.size() > alone)
  for (std::int64_t g = 0; g < count; ++g) {
    Group& group = result[g];
    group.first = static_cast<std::uint32_t>(g * together);
    group.count = static_cast<std::uint32_t>(std::min(together, pieces.size() - group.first));
    group.box = pieces[group.first].box;
    for (std::size_t i = group.first + 1; i < group.first + group.count; ++i)
      extend(group.box, pieces[i].box);
  }
  return result;
}

/** The tree over \p groups first to last. \p free: index of the first of the boxes for what is below this node, two for each piece but
 *  one. */
void
MoveIndex::build(std::vector<Group>& groups, std::size_t first, std::size_t last, const std::vector<Piece>& pieces, std::size_t node,
                 std::size_t free)
{
  if (last - first == 1)
    return build(pieces, groups[first].first, groups[first].first + groups[first].count, node, free);
  Box4 box = groups[first].box, middles;
  middles.low.fill(1e30f);
  middles.high.fill(-1e30f);
  for (std::size_t i = first; i < last; ++i) {
    extend(box, groups[i].box);
    for (int d = 0; d < 3; ++d) {
      const float middle = groups[i].box.low[d] + groups[i].box.high[d];
      middles.low[d] = std::min(middles.low[d], middle);
      middles.high[d] = std::max(middles.high[d], middle);
    }
  }
  boxes_[node] = box;
  int axis = 0;
  for (int d = 1; d < 3; ++d)
    if (middles.high[d] - middles.low[d] > middles.high[axis] - middles.low[axis])
      axis = d;
  const std::size_t half = first + (last - first) / 2;
  const auto begin = groups.begin();
  std::nth_element(
      begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(half), begin + static_cast<std::ptrdiff_t>(last),
      [axis](const Group& a, const Group& b) { return a.box.low[axis] + a.box.high[axis] < b.box.low[axis] + b.box.high[axis]; });
  std::size_t below = 0; // pieces in the first half
  for (std::size_t i = first; i < half; ++i)
    below += groups[i].count;
  next_[node] = static_cast<std::uint32_t>(free);
#pragma omp task shared(groups, pieces) if (below > alone)
  build(groups, first, half, pieces, free, free + 2);
  build(groups, half, last, pieces, free + 1, free + 2 * below);
}

/** The tree over \p pieces first to last, halved in their order. */
void
MoveIndex::build(const std::vector<Piece>& pieces, std::size_t first, std::size_t last, std::size_t node, std::size_t free)
{
  boxes_[node] = pieces[first].box;
  for (std::size_t i = first + 1; i < last; ++i)
    extend(boxes_[node], pieces[i].box);
  if (last - first == 1) {
    next_[node] = leaf | pieces[first].move;
    return;
  }
  const std::size_t half = first + (last - first) / 2;
  next_[node] = static_cast<std::uint32_t>(free);
  build(pieces, first, half, free, free + 2);
  build(pieces, half, last, free + 1, free + 2 * (half - first));
}

bool
MoveIndex::nearest(const Eigen::Vector3d& p, double& distance, Eigen::Vector3d& point) const
{
  bool found = false;
  search(
      p, [&] { return distance; },
      [&](std::size_t move) {
        const Eigen::Vector3d d = line_[move + 1] - line_[move], m = p - line_[move];
        const double whole = d.squaredNorm();
        const double f = whole > 0.0 ? std::clamp(m.dot(d) / whole, 0.0, 1.0) : 0.0;
        const double there = (m - f * d).norm();
        if (there >= distance)
          return;
        distance = there;
        point = line_[move] + f * d;
        found = true;
      });
  return found;
}

} // namespace pcl_spiral
