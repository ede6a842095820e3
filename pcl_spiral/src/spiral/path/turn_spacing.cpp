// SPDX-License-Identifier: BSD-3-Clause
#include "turn_spacing.h"

#include <pcl_spiral/core/impl/pass_ranges.h>
#include <pcl_spiral/search/impl/move_index.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

/** A point of the path, and its distance from another turn. */
struct Nearest {
  double distance = 0.0;
  std::size_t point = std::numeric_limits<std::size_t>::max();

  bool operator<(const Nearest& other) const { return distance < other.distance || (distance == other.distance && point < other.point); }
};

double
distanceFromMove(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  const Eigen::Vector3d d = b - a, m = p - a;
  const double length = d.squaredNorm();
  return (m - (length > 0.0 ? std::clamp(m.dot(d) / length, 0.0, 1.0) : 0.0) * d).norm();
}

} // namespace

ClosestTurns
closestTurns(const SpiralPath& path, const std::vector<std::uint8_t>& counted, const std::vector<double>& along, double apart,
             double within)
{
  ClosestTurns closest;
  if (std::none_of(counted.begin(), counted.end(), [](std::uint8_t marked) { return marked != 0; }))
    return closest;
  const Polyline& contacts = path.onSurface();
  const MoveIndex index(contacts);
  Nearest least;
  least.distance = within;
  const auto count = static_cast<std::int64_t>(contacts.size());
#pragma omp parallel
  {
    Nearest mine = least;
#pragma omp for schedule(dynamic, 1024)
    for (std::int64_t i = 0; i < count; ++i) {
      if (!counted[i])
        continue;
      const Eigen::Vector3d& place = contacts[i];
      index.search(
          place, [&mine] { return mine.distance; },
          [&](std::size_t move) {
            if (!counted[move] || !counted[move + 1] || beginsPass(path.passes, move + 1) || std::abs(along[move] - along[i]) < apart ||
                std::abs(along[move + 1] - along[i]) < apart)
              return;
            mine = std::min(mine, {distanceFromMove(place, contacts[move], contacts[move + 1]), static_cast<std::size_t>(i)});
          });
    }
#pragma omp critical(pcl_spiral_closest_turns)
    least = std::min(least, mine);
  }
  if (least.point < contacts.size())
    closest = {least.distance, contacts[least.point]};
  return closest;
}

} // namespace pcl_spiral
