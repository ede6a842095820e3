#include <pcl_spiral/core/self_crossing.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace pcl_spiral {
namespace {

constexpr double width_in_longest = 1.4; // of a cell: smaller ones cost more to look up than they leave out

/** The segments of a path by the cells in which their middles lie. Cells share buckets, by a hash under which
 *  neighbours along x follow each other; a segment of another cell in a bucket does no harm. Eight bytes a
 *  segment. */
class SegmentCells {
public:
  using Cell = Eigen::Matrix<std::int64_t, 3, 1>;

  SegmentCells(const Polyline& path, double width) : path_(path), width_(width)
  {
    const std::size_t segments = path.size() - 1;
    std::size_t buckets = 1;
    while (buckets < segments)
      buckets *= 2;
    mask_ = buckets - 1;
    begin_.assign(buckets + 1, 0);
    // Each segment's place depends on those before it: serial.
    for (std::size_t i = 0; i < segments; ++i)
      ++begin_[bucketOf(cellAt(middle(i)))];
    std::uint32_t before = 0;
    for (std::uint32_t& entry : begin_)
      entry = before += entry;
    segments_.resize(segments);
    for (std::size_t i = segments; i-- > 0;)
      segments_[--begin_[bucketOf(cellAt(middle(i)))]] = static_cast<std::uint32_t>(i);
  }

  Eigen::Vector3d
  middle(std::size_t segment) const
  {
    return 0.5 * (path_[segment] + path_[segment + 1]);
  }

  /** Call \p visit with the segments from \p first on whose middle may lie within \p reach of \p place. */
  template <typename Visit>
  void
  visitNear(const Eigen::Vector3d& place, double reach, std::size_t first, Visit visit) const
  {
    const Eigen::Vector3d half = Eigen::Vector3d::Constant(reach);
    const Cell low = cellAt(place - half), high = cellAt(place + half);
    const std::size_t columns = high.x() - low.x() + 1;
    const auto visitBuckets = [&](std::size_t from, std::size_t end) {
      for (std::uint32_t k = begin_[from]; k < begin_[end]; ++k)
        if (segments_[k] >= first)
          visit(segments_[k]);
    };
    for (std::int64_t z = low.z(); z <= high.z(); ++z)
      for (std::int64_t y = low.y(); y <= high.y(); ++y) {
        const std::size_t bucket = bucketOf(Cell(low.x(), y, z));
        if (bucket + columns <= mask_ + 1)
          visitBuckets(bucket, bucket + columns);
        else
          for (std::size_t next = bucket; next < bucket + columns; ++next)
            visitBuckets(next & mask_, (next & mask_) + 1);
      }
  }

private:
  Cell
  cellAt(const Eigen::Vector3d& place) const
  {
    return (place / width_).array().floor().matrix().cast<std::int64_t>();
  }

  std::size_t
  bucketOf(const Cell& cell) const
  {
    return (static_cast<std::size_t>(cell.x()) + 73856093u * static_cast<std::size_t>(cell.y()) +
            19349663u * static_cast<std::size_t>(cell.z())) & mask_;
  }

  const Polyline& path_;
  double width_;
  std::size_t mask_ = 0;
  std::vector<std::uint32_t> begin_, segments_;
};

/** Twice the area of a b c as seen along \p n, over the length of a b: how far c lies to its left. */
double
sideOf(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& n)
{
  const double chord = (b - a).norm();
  return chord > 0.0 ? (b - a).cross(c - a).dot(n) / chord : 0.0;
}

bool
apart(double one, double other, double slack)
{
  return one * other < 0.0 && std::min(std::abs(one), std::abs(other)) > slack;
}

bool
cross(const Polyline& p, std::size_t i, std::size_t j, const Eigen::Vector3d& n, double slack)
{
  const double reach = 0.5 * ((p[i + 1] - p[i]).norm() + (p[j + 1] - p[j]).norm());
  return 0.25 * (p[i] + p[i + 1] - p[j] - p[j + 1]).squaredNorm() <= reach * reach &&
         apart(sideOf(p[i], p[i + 1], p[j], n), sideOf(p[i], p[i + 1], p[j + 1], n), slack) &&
         apart(sideOf(p[j], p[j + 1], p[i], n), sideOf(p[j], p[j + 1], p[i + 1], n), slack);
}

} // namespace

std::optional<std::size_t>
firstSelfCrossing(const Polyline& path, const std::vector<Eigen::Vector3d>& normals, double slack)
{
  if (path.size() < 4)
    return std::nullopt;
  const auto segments = static_cast<std::int64_t>(path.size()) - 1;
  double longest = 0.0;
#pragma omp parallel for schedule(static) reduction(max : longest)
  for (std::int64_t i = 0; i < segments; ++i)
    longest = std::max(longest, (path[i + 1] - path[i]).squaredNorm());
  if (!(longest > 0.0))
    return std::nullopt;
  longest = std::sqrt(longest);
  const SegmentCells cells(path, width_in_longest * longest);
  auto first = std::numeric_limits<std::int64_t>::max();
#pragma omp parallel for schedule(dynamic, 4096) reduction(min : first)
  for (std::int64_t i = 0; i < segments; ++i) {
    if (i >= first)
      continue;
    const Eigen::Vector3d start = path[i], along = path[i + 1] - start, left = normals[i].cross(along);
    const double reach = 0.5000001 * (along.norm() + longest);
    cells.visitNear(cells.middle(i), reach, i + 2, [&](std::size_t j) {
      // Hardly any has its ends on either side.
      if (left.dot(path[j] - start) * left.dot(path[j + 1] - start) < 0.0 &&
          cross(path, i, j, normals[i], slack))
        first = i;
    });
  }
  return first < segments ? std::optional<std::size_t>(static_cast<std::size_t>(first)) : std::nullopt;
}

} // namespace pcl_spiral
