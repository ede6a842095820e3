// SPDX-License-Identifier: BSD-3-Clause
#include "place_groups.h"

#include <array>
#include <cmath>
#include <map>

namespace pcl_spiral {

std::vector<std::size_t>
placeGroups(const Polyline& points, double edge, std::size_t& count)
{
  using Cell = std::array<long, 3>;
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::map<Cell, std::size_t> group_of;
  const auto cellOf = [&](const Eigen::Vector3d& point) {
    const Eigen::Array3d at = ((point - points.front()) / edge).array().floor();
    return Cell{static_cast<long>(at.x()), static_cast<long>(at.y()), static_cast<long>(at.z())};
  };
  for (const Eigen::Vector3d& point : points)
    group_of[cellOf(point)] = none;
  count = 0;
  std::vector<std::size_t> groups;
  std::vector<Cell> open;
  for (const Eigen::Vector3d& point : points) {
    const Cell first = cellOf(point);
    if (group_of[first] == none) {
      group_of[first] = count;
      open.assign(1, first);
      while (!open.empty()) {
        const Cell cell = open.back();
        open.pop_back();
        for (int k = 0; k < 27; ++k) {
          const auto beside = group_of.find({cell[0] + k % 3 - 1, cell[1] + k / 3 % 3 - 1, cell[2] + k / 9 - 1});
          if (beside == group_of.end() || beside->second != none)
            continue;
          beside->second = count;
          open.push_back(beside->first);
        }
      }
      ++count;
    }
    groups.push_back(group_of[first]);
  }
  return groups;
}

} // namespace pcl_spiral
