// SPDX-License-Identifier: BSD-3-Clause
#include "core/median.h"

#include <pcl_spiral/search/impl/point_blocks.h>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <utility>

namespace pcl_spiral {
namespace {

/** A total order on positions, one axis after the other, so that equal coordinates never leave the order to chance. */
struct AxisOrder {
  std::array<int, 3> axes;
  bool operator()(const IndexedPosition& a, const IndexedPosition& b) const
  {
    const float* p = &a.x;
    const float* q = &b.x;
    for (const int i : axes)
      if (p[i] != q[i])
        return p[i] < q[i];
    return a.index < b.index;
  }
};

/** The axes, longest side of the box first. A scan line along which one coordinate is constant is then cut along its length,
 *  never by height, which would put all points lowered by noise into one block. */
std::array<int, 3>
axesBySide(const Box& box)
{
  std::array<int, 3> axes{0, 1, 2};
  std::stable_sort(axes.begin(), axes.end(), [&](int a, int b) { return box.high[a] - box.low[a] > box.high[b] - box.low[b]; });
  return axes;
}

/** Puts the \p smaller first positions in the order of one axis before the others. Slices of equal width across the
 *  axis are counted; only the slice that contains the cut has to be put in order. */
class AxisCut {
public:
  AxisCut(const Box& box, std::size_t count) : axes_(axesBySide(box)), axis_(axes_[0])
  {
    slices_ = static_cast<int>(std::min<std::size_t>(most_slices, std::max<std::size_t>(8, count / 8)));
    low_ = box.low[axis_];
    const float width = box.high[axis_] - low_;
    scale_ = width > 0.0f ? (static_cast<float>(slices_) - 0.5f) / width : 0.0f;
  }

  void apply(IndexedPosition* begin, std::size_t count, std::size_t smaller)
  {
    std::array<std::uint32_t, most_slices> in_slice{};
    for (std::size_t i = 0; i < count; ++i)
      ++in_slice[sliceOf(begin[i])];
    std::size_t before = 0;
    int cut = 0;
    for (; before + in_slice[cut] <= smaller; ++cut)
      before += in_slice[cut];
    IndexedPosition* const middle = split(begin, begin + count, [&](int slice) { return slice < cut; });
    IndexedPosition* const end = split(middle, begin + count, [&](int slice) { return slice == cut; });
    std::nth_element(middle, begin + smaller, end, AxisOrder{axes_});
  }

private:
  static constexpr int most_slices = 1024;

  int sliceOf(const IndexedPosition& p) const
  {
    return static_cast<int>(std::min(static_cast<float>(slices_ - 1), ((&p.x)[axis_] - low_) * scale_));
  }

  /** Positions whose slices \p belong come first; returns where the others begin. Every step does the same, so that there
   *  is no branch to predict. */
  template <typename Belongs>
  IndexedPosition* split(IndexedPosition* begin, IndexedPosition* end, Belongs belong) const
  {
    IndexedPosition* others = begin;
    for (IndexedPosition* p = begin; p != end; ++p) {
      const IndexedPosition here = *p;
      *p = *others;
      *others = here;
      others += belong(sliceOf(here));
    }
    return others;
  }

  std::array<int, 3> axes_;
  int axis_;
  int slices_;
  float low_, scale_;
};

/** Sorts the items of a partition's node: the blocks from \p node 2^level on. */
void
sortNode(IndexedPosition* all, const BlockPartition& partition, std::size_t node, int level)
{
  const std::size_t begin = partition.begin(node << level), end = partition.begin((node + 1) << level);
  if (level == 0) {
    std::sort(all + begin, all + end, AxisOrder{{0, 1, 2}});
    return;
  }
  Box box;
  for (std::size_t i = begin; i < end; ++i)
    box.extend(&all[i].x);
  const std::size_t middle = partition.begin((2 * node + 1) << (level - 1));
  AxisCut(box, end - begin).apply(all + begin, end - begin, middle - begin);
  constexpr std::size_t worth_a_task = 20000;
#pragma omp task if (end - begin > worth_a_task)
  sortNode(all, partition, 2 * node, level - 1);
  sortNode(all, partition, 2 * node + 1, level - 1);
#pragma omp taskwait
}

} // namespace

void
sortSpatially(std::vector<IndexedPosition>& positions)
{
  const BlockPartition partition(positions.size());
#pragma omp parallel
#pragma omp single
  sortNode(positions.data(), partition, 0, partition.halvings());
}

PointBlocks::PointBlocks(std::vector<Eigen::Vector3f> points) : points_(std::move(points)), partition_(points_.size())
{
  sort();
  findBoxes();
}

PointBlocks
PointBlocks::inOrder(std::vector<Eigen::Vector3f> points)
{
  PointBlocks blocks;
  blocks.points_ = std::move(points);
  blocks.partition_ = BlockPartition(blocks.points_.size());
  blocks.original_.resize(blocks.points_.size());
  std::iota(blocks.original_.begin(), blocks.original_.end(), 0U);
  blocks.findBoxes();
  return blocks;
}

void
PointBlocks::sort()
{
  const auto count = static_cast<std::int64_t>(points_.size());
  std::vector<IndexedPosition> order(points_.size());
#pragma omp parallel for schedule(static)
  for (std::int64_t i = 0; i < count; ++i)
    order[i] = {points_[i].x(), points_[i].y(), points_[i].z(), static_cast<std::uint32_t>(i)};
  sortSpatially(order);
  original_.resize(order.size());
#pragma omp parallel for schedule(static)
  for (std::int64_t i = 0; i < count; ++i) {
    points_[i] = {order[i].x, order[i].y, order[i].z};
    original_[i] = order[i].index;
  }
}

void
PointBlocks::findBoxes()
{
  const std::size_t blocks = blockCount();
  boxes_.assign(std::max<std::size_t>(2, 2 * blocks), Box());
#pragma omp parallel for schedule(static)
  for (std::int64_t b = 0; b < static_cast<std::int64_t>(blocks); ++b)
    for (std::size_t i = blockBegin(b); i < blockEnd(b); ++i)
      boxes_[blocks + b].extend(points_[i].data());
  for (std::size_t i = blocks; i-- > 1;) {
    boxes_[i] = boxes_[2 * i];
    boxes_[i].extend(boxes_[2 * i + 1]);
  }
  std::vector<float> diagonals;
  for (std::size_t b = 0; b < blocks; ++b)
    diagonals.push_back(blockBox(b).diagonal());
  if (blocks > 0)
    usual_diagonal_ = medianOf(std::move(diagonals));
}

std::uint32_t
PointBlocks::nearest(const Eigen::Vector3d& query) const
{
  const Eigen::Vector3f q = query.cast<float>();
  const std::size_t leaves = blockCount();
  std::uint32_t best = 0;
  float best_distance = std::numeric_limits<float>::max();
  std::array<std::uint32_t, 64> stack;
  std::size_t top = 0;
  stack[top++] = 1;
  while (top > 0) {
    const std::uint32_t node = stack[--top];
    if (boxes_[node].squaredDistance(q.data()) >= best_distance)
      continue;
    if (node < leaves) {
      const bool right_first = boxes_[2 * node + 1].squaredDistance(q.data()) < boxes_[2 * node].squaredDistance(q.data());
      stack[top++] = 2 * node + (right_first ? 0 : 1);
      stack[top++] = 2 * node + (right_first ? 1 : 0);
      continue;
    }
    for (std::size_t i = blockBegin(node - leaves); i < blockEnd(node - leaves); ++i) {
      const float distance = (points_[i] - q).squaredNorm();
      if (distance < best_distance) {
        best_distance = distance;
        best = static_cast<std::uint32_t>(i);
      }
    }
  }
  return best;
}

} // namespace pcl_spiral
