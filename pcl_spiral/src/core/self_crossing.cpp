// SPDX-License-Identifier: BSD-3-Clause
#include "self_crossing.h"

#include <pcl_spiral/core/impl/pass_ranges.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace pcl_spiral {
namespace {

constexpr double width_in_mean = 1.5; // of a cell, in mean segments: smaller cells take more time to look up than they save
constexpr double most_cells_along = 16.0;
constexpr double margin_in_width = 0.1; // segments that cross may lie this far above each other
constexpr double margin_in_slack = 4.0;
constexpr std::int64_t chunk = 1 << 16; // segments between two calls of go_on

/** The segments of a path, by the cells that their boxes touch. Cells share buckets through a hash; a segment of
 * another cell in a bucket does no harm. About eighteen bytes per segment. */
class SegmentCells {
public:
  using Cell = Eigen::Matrix<std::int64_t, 3, 1>;

  SegmentCells(const Polyline& path, const std::vector<std::size_t>& passes, double width) : path_(path), width_(width)
  {
    const std::size_t segments = path.size() - 1;
    std::size_t buckets = 1;
    while (buckets < segments)
      buckets *= 2;
    mask_ = buckets - 1;
    begin_.assign(buckets + 1, 0);
    // Serial: the place of each segment depends on those before it.
    for (std::size_t i = 0; i < segments; ++i)
      if (!beginsPass(passes, i + 1))
        forBuckets(i, 0.0, [&](std::size_t bucket) { ++begin_[bucket]; });
    std::uint32_t before = 0;
    for (std::uint32_t& entry : begin_)
      entry = before += entry;
    segments_.resize(before);
    for (std::size_t i = segments; i-- > 0;)
      if (!beginsPass(passes, i + 1))
        forBuckets(i, 0.0, [&](std::size_t bucket) { segments_[--begin_[bucket]] = static_cast<std::uint32_t>(i); });
  }

  /** Call \p visit with those segments after the next one that may come within \p margin of a segment. */
  template <typename Visit>
  void visitNear(std::size_t segment, double margin, Visit visit) const
  {
    forBuckets(segment, margin, [&](std::size_t bucket) {
      for (std::uint32_t k = begin_[bucket + 1]; k-- > begin_[bucket] && segments_[k] > segment + 1;)
        visit(segments_[k]);
    });
  }

private:
  template <typename Visit>
  void forBuckets(std::size_t segment, double margin, Visit visit) const
  {
    const Eigen::Vector3d &a = path_[segment], &b = path_[segment + 1], reach = Eigen::Vector3d::Constant(margin);
    const Cell low = cellAt(a.cwiseMin(b) - reach), high = cellAt(a.cwiseMax(b) + reach);
    for (std::int64_t z = low.z(); z <= high.z(); ++z)
      for (std::int64_t y = low.y(); y <= high.y(); ++y)
        for (std::int64_t x = low.x(); x <= high.x(); ++x)
          visit((static_cast<std::size_t>(x) + 73856093u * static_cast<std::size_t>(y) + 19349663u * static_cast<std::size_t>(z)) & mask_);
  }

  Cell cellAt(const Eigen::Vector3d& place) const { return (place / width_).array().floor().matrix().cast<std::int64_t>(); }

  const Polyline& path_;
  double width_;
  std::size_t mask_ = 0;
  std::vector<std::uint32_t> begin_, segments_;
};

/** Twice the area of a b c as seen along \p n, over the length of a b: how far c lies to the left of a b. */
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
firstSelfCrossing(const Polyline& path, const std::vector<Eigen::Vector3d>& normals, double slack, const std::function<bool(double)>& go_on,
                  const std::vector<std::size_t>& passes)
{
  if (path.size() < 4)
    return std::nullopt;
  const auto segments = static_cast<std::int64_t>(path.size()) - 1;
  double longest = 0.0, sum = 0.0;
  for (std::int64_t i = 0; i < segments; ++i) { // serial: the rounding of a sum depends on its order
    const double length = beginsPass(passes, static_cast<std::size_t>(i) + 1) ? 0.0 : (path[i + 1] - path[i]).norm();
    longest = std::max(longest, length);
    sum += length;
  }
  if (!(longest > 0.0))
    return std::nullopt;
  const double width = std::max(width_in_mean * sum / static_cast<double>(segments), longest / most_cells_along);
  const double margin = margin_in_slack * slack + margin_in_width * width;
  const SegmentCells cells(path, passes, width);
  auto first = std::numeric_limits<std::int64_t>::max();
  for (std::int64_t begin = 0; begin < segments && first > segments; begin += chunk) {
    if (go_on && !go_on(static_cast<double>(begin) / static_cast<double>(segments)))
      return std::nullopt;
    const std::int64_t end = std::min(begin + chunk, segments);
#pragma omp parallel for schedule(dynamic, 1024) reduction(min : first)
    for (std::int64_t i = begin; i < end; ++i) {
      if (i >= first || beginsPass(passes, static_cast<std::size_t>(i) + 1))
        continue;
      const Eigen::Vector3d start = path[i], along = path[i + 1] - start, left = normals[i].cross(along);
      cells.visitNear(i, margin, [&](std::size_t j) {
        // Few segments have their ends on different sides.
        if (left.dot(path[j] - start) * left.dot(path[j + 1] - start) < 0.0 && cross(path, i, j, normals[i], slack))
          first = i;
      });
    }
  }
  return first < segments ? std::optional<std::size_t>(static_cast<std::size_t>(first)) : std::nullopt;
}

} // namespace pcl_spiral
