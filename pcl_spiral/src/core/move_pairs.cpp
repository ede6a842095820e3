// SPDX-License-Identifier: BSD-3-Clause
#include "move_pairs.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl_spiral {
namespace {

constexpr double width_in_mean = 1.5; // of a cell, in mean segments: smaller cells take more time to look up than they save
constexpr double most_cells_along = 16.0;
constexpr double margin_in_width = 0.1; // segments that cross may lie this far above each other
constexpr double margin_in_slack = 4.0;
constexpr std::size_t sum_block = 4096; // moves: the rounding of a sum depends on its order

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

} // namespace

MovePairs::MovePairs(const Polyline& path, const std::vector<Eigen::Vector3d>& normals, double slack,
                     const std::vector<std::size_t>& passes)
: path_(path), normals_(normals), passes_(passes), slack_(slack)
{
  if (path.size() < 2)
    return;
  const std::size_t moves = path.size() - 1;
  const auto blocks = static_cast<std::int64_t>((moves + sum_block - 1) / sum_block);
  std::vector<double> sums(blocks, 0.0);
  double longest = 0.0;
#pragma omp parallel for schedule(static) reduction(max : longest)
  for (std::int64_t b = 0; b < blocks; ++b)
    for (std::size_t i = b * sum_block; i < std::min(moves, (b + 1) * sum_block); ++i) {
      const double length = isLift(i) ? 0.0 : (path[i + 1] - path[i]).norm();
      longest = std::max(longest, length);
      sums[b] += length;
    }
  const double sum = std::accumulate(sums.begin(), sums.end(), 0.0);
  if (!(longest > 0.0))
    return;
  const double width = std::max(width_in_mean * sum / static_cast<double>(moves), longest / most_cells_along);
  margin_ = margin_in_slack * slack + margin_in_width * width;
  cells_ = std::make_unique<MoveCells>(
      path, [this](std::size_t i) { return !isLift(i); }, width);
}

bool
MovePairs::cross(std::size_t i, std::size_t j) const
{
  const Polyline& p = path_;
  const Eigen::Vector3d& n = normals_[i];
  const double reach = 0.5 * ((p[i + 1] - p[i]).norm() + (p[j + 1] - p[j]).norm());
  return 0.25 * (p[i] + p[i + 1] - p[j] - p[j + 1]).squaredNorm() <= reach * reach &&
         apart(sideOf(p[i], p[i + 1], p[j], n), sideOf(p[i], p[i + 1], p[j + 1], n), slack_) &&
         apart(sideOf(p[j], p[j + 1], p[i], n), sideOf(p[j], p[j + 1], p[i + 1], n), slack_);
}

} // namespace pcl_spiral
