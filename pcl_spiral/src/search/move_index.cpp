// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/search/impl/move_index.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace pcl_spiral {
namespace {

constexpr double longest_piece = 2.0; // in mean lengths: at most half as many pieces again as segments
constexpr std::size_t alone = 1024;   // groups that one thread puts into boxes; only speed: the boxes are the same
constexpr std::size_t together = 4;   // pieces of a group
constexpr float rounding = 1.2e-7f;   // of a coordinate, at least the next number in single precision

} // namespace

MoveIndex::MoveIndex(const Polyline& line) : line_(line)
{
  if (line_.size() < 2)
    return;
  if (moves() > std::size_t{first_mask} + 1)
    throw std::length_error("a line of more than 2^29 segments has no index");
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : line_)
    box.extend(p);
  origin_ = box.center();
  slack_ = 4e-7 * box.diagonal().norm();
  std::vector<Group> sorted = groups();
  boxes_.resize(2 * sorted.size() - 1);
  next_.resize(2 * sorted.size() - 1);
#pragma omp parallel if (sorted.size() > 2 * alone)
#pragma omp single
  build(sorted, 0, sorted.size(), 0, 1);
}

/** Consecutive pieces are near each other already: they stay together, and only their groups are sorted. */
std::vector<MoveIndex::Group>
MoveIndex::groups() const
{
  const double limit = longest_piece * length(line_) / static_cast<double>(moves());
  const auto parts = [&](std::size_t i) {
    return limit > 0.0 ? std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil((line_[i + 1] - line_[i]).norm() / limit))) : 1;
  };
  constexpr std::size_t moves_a_block = together * alone;
  const auto blocks = static_cast<std::int64_t>((moves() + moves_a_block - 1) / moves_a_block);
  const auto endOf = [this](std::size_t block) { return std::min(moves(), (block + 1) * moves_a_block); };
  std::vector<std::size_t> begin(blocks + 1, 0); // of each block's groups
#pragma omp parallel for schedule(static) if (blocks > 1)
  for (std::int64_t b = 0; b < blocks; ++b) {
    std::size_t pieces = 0;
    for (std::size_t i = b * moves_a_block; i < endOf(b); ++i)
      pieces += parts(i);
    begin[b + 1] = (pieces + together - 1) / together;
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<Group> result(begin.back());
#pragma omp parallel for schedule(static) if (blocks > 1)
  for (std::int64_t b = 0; b < blocks; ++b) {
    std::size_t piece = 0;
    for (std::size_t i = b * moves_a_block; i < endOf(b); ++i) {
      const Eigen::Vector3d a = line_[i] - origin_, d = line_[i + 1] - line_[i];
      const std::size_t count = parts(i);
      for (std::size_t k = 0; k < count; ++k, ++piece) {
        Group& group = result[begin[b] + piece / together];
        const Eigen::Vector3f p = (a + d * (static_cast<double>(k) / static_cast<double>(count))).cast<float>();
        const Eigen::Vector3f q = (a + d * (static_cast<double>(k + 1) / static_cast<double>(count))).cast<float>();
        Box4 box{};
        for (int axis = 0; axis < 3; ++axis) {
          const float low = std::min(p[axis], q[axis]), high = std::max(p[axis], q[axis]);
          box.low[axis] = low - rounding * std::abs(low);
          box.high[axis] = high + rounding * std::abs(high);
        }
        if (piece % together == 0)
          group = {box, leaf_mark | static_cast<std::uint32_t>(i)};
        else
          extend(group.box, box);
        group.moves = (group.moves & (leaf_mark | first_mask)) | (static_cast<std::uint32_t>(i) - (group.moves & first_mask))
                                                                     << count_shift;
      }
    }
  }
  return result;
}

/** The tree over \p groups first to last. \p free: index of the first of the boxes for what is below this node, two for each group but
 *  one. */
void
MoveIndex::build(std::vector<Group>& groups, std::size_t first, std::size_t last, std::size_t node, std::size_t free)
{
  Box4 box = groups[first].box, middles;
  if (last - first == 1) {
    boxes_[node] = box;
    next_[node] = groups[first].moves;
    return;
  }
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
  next_[node] = static_cast<std::uint32_t>(free);
#pragma omp task shared(groups) if (half - first > alone)
  build(groups, first, half, free, free + 2);
  build(groups, half, last, free + 1, free + 2 * (half - first));
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
