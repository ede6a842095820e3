// SPDX-License-Identifier: BSD-3-Clause
#include "self_crossing.h"

#include "core/move_cells.h"

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
  const auto isSegment = [&passes](std::size_t i) { return !beginsPass(passes, i + 1); };
  const MoveCells cells(path, isSegment, width);
  auto first = std::numeric_limits<std::int64_t>::max();
  for (std::int64_t begin = 0; begin < segments && first > segments; begin += chunk) {
    if (go_on && !go_on(static_cast<double>(begin) / static_cast<double>(segments)))
      return std::nullopt;
    const std::int64_t end = std::min(begin + chunk, segments);
#pragma omp parallel for schedule(dynamic, 1024) reduction(min : first)
    for (std::int64_t i = begin; i < end; ++i) {
      if (i >= first || !isSegment(static_cast<std::size_t>(i)))
        continue;
      const Eigen::Vector3d &start = path[i], &finish = path[i + 1], along = finish - start, left = normals[i].cross(along);
      const Eigen::Vector3d reach = Eigen::Vector3d::Constant(margin);
      cells.forBuckets(start.cwiseMin(finish) - reach, start.cwiseMax(finish) + reach,
                       [&](const std::uint32_t* low, const std::uint32_t* high) {
                         while (high != low && *--high > i + 1) {
                           const std::uint32_t j = *high;
                           // Few segments have their ends on different sides.
                           if (left.dot(path[j] - start) * left.dot(path[j + 1] - start) < 0.0 && cross(path, i, j, normals[i], slack))
                             first = i;
                         }
                       });
    }
  }
  return first < segments ? std::optional<std::size_t>(static_cast<std::size_t>(first)) : std::nullopt;
}

} // namespace pcl_spiral
