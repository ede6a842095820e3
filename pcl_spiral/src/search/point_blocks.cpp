#include <pcl_spiral/search/point_blocks.h>

#include <limits>

namespace pcl_spiral {
namespace {

/** A total order on positions that starts with one axis, so that equal coordinates never leave it to chance. */
struct AxisOrder {
  int axis;
  bool
  operator()(const IndexedPosition& a, const IndexedPosition& b) const
  {
    const float* p = &a.x;
    const float* q = &b.x;
    for (int d = 0; d < 3; ++d) {
      const int i = (axis + d) % 3;
      if (p[i] != q[i])
        return p[i] < q[i];
    }
    return a.index < b.index;
  }
};

void
sortRun(IndexedPosition* begin, std::size_t count)
{
  if (count <= PointBlocks::block_size) {
    std::sort(begin, begin + count, AxisOrder{0});
    return;
  }
  Box box;
  for (std::size_t i = 0; i < count; ++i)
    box.extend(&begin[i].x);
  int axis = 0;
  for (int d = 1; d < 3; ++d)
    if (box.high[d] - box.low[d] > box.high[axis] - box.low[axis])
      axis = d;
  const std::size_t blocks = (count + PointBlocks::block_size - 1) / PointBlocks::block_size;
  const std::size_t half = (blocks / 2) * PointBlocks::block_size;
  std::nth_element(begin, begin + half, begin + count, AxisOrder{axis});
  constexpr std::size_t worth_a_task = 20000;
#pragma omp task if (count > worth_a_task)
  sortRun(begin, half);
  sortRun(begin + half, count - half);
#pragma omp taskwait
}

} // namespace

void
sortSpatially(std::vector<IndexedPosition>& positions)
{
#pragma omp parallel
#pragma omp single
  sortRun(positions.data(), positions.size());
}

PointBlocks::PointBlocks(const std::vector<Eigen::Vector3f>& points)
{
  std::vector<IndexedPosition> order(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    order[i] = {points[i].x(), points[i].y(), points[i].z(), static_cast<std::uint32_t>(i)};
  sortSpatially(order);
  points_.resize(order.size());
  original_.resize(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    points_[i] = {order[i].x, order[i].y, order[i].z};
    original_[i] = order[i].index;
  }
  const std::size_t blocks = blockCount();
  while (leaves_ < blocks)
    leaves_ *= 2;
  boxes_.assign(2 * leaves_, Box());
  for (std::size_t b = 0; b < blocks; ++b)
    for (std::size_t i = blockBegin(b); i < blockEnd(b); ++i)
      boxes_[leaves_ + b].extend(points_[i].data());
  for (std::size_t i = leaves_ - 1; i >= 1; --i) {
    boxes_[i] = boxes_[2 * i];
    boxes_[i].extend(boxes_[2 * i + 1]);
  }
}

std::uint32_t
PointBlocks::nearest(const Eigen::Vector3d& query) const
{
  const Eigen::Vector3f q = query.cast<float>();
  std::uint32_t best = 0;
  float best_distance = std::numeric_limits<float>::max();
  std::array<std::uint32_t, 64> stack;
  std::size_t top = 0;
  stack[top++] = 1;
  while (top > 0) {
    const std::uint32_t node = stack[--top];
    if (boxes_[node].squaredDistance(q.data()) >= best_distance)
      continue;
    if (node < leaves_) {
      const bool right_first =
          boxes_[2 * node + 1].squaredDistance(q.data()) < boxes_[2 * node].squaredDistance(q.data());
      stack[top++] = 2 * node + (right_first ? 0 : 1);
      stack[top++] = 2 * node + (right_first ? 1 : 0);
      continue;
    }
    for (std::size_t i = blockBegin(node - leaves_); i < blockEnd(node - leaves_); ++i) {
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
