// SPDX-License-Identifier: BSD-3-Clause
#include "path_pick.h"

#include "visualization/path_layer.h"

#include <algorithm>
#include <array>
#include <vector>

namespace pcl_spiral {
namespace {

constexpr double pick_reach = 12.0; ///< pixels
constexpr int most_tries = 20;      ///< of each side: points behind the part are among those in front of it

} // namespace

std::optional<std::size_t>
pickPoint(const PartView& view, const pcl::PointCloud<ToolpathPoint>& path, const std::function<bool(const ToolpathPoint&)>& shown,
          const Eigen::Vector2d& pixel)
{
  const Eigen::Vector3d towards = view.projection().towards();
  std::array<std::vector<std::pair<double, std::size_t>>, 2> found; // points that face the viewer, and the others
  for (std::size_t i = 0; i < path.size(); ++i) {
    const double off = (view.onScreen(placeOf(path[i])) - pixel).norm();
    if (off <= pick_reach && shown(path[i]))
      found[normalOf(path[i]).dot(towards) > 0.0 ? 0 : 1].emplace_back(off, i);
  }
  for (auto& side : found) {
    std::sort(side.begin(), side.end());
    for (std::size_t k = 0; k < side.size() && k < most_tries; ++k)
      if (!hides(view.surface(), placeOf(path[side[k].second]), towards))
        return side[k].second;
  }
  return std::nullopt;
}

} // namespace pcl_spiral
