// SPDX-License-Identifier: BSD-3-Clause
#include "path_densify.h"

#include <pcl_spiral/core/impl/pass_ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_spiral {

void
densify(const std::vector<std::uint8_t>& near, double held, double grain, LinkedPath& path, std::vector<std::uint8_t>& dense_near,
        std::vector<std::uint8_t>& moves, std::vector<std::size_t>& places)
{
  places.clear();
  LinkedPath dense;
  dense.points.reserve(path.points.size());
  dense.metric.reserve(path.points.size());
  double travelled = 0.0;
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    const bool moves_on = i > 0 && !beginsPass(path.passes, i);
    double step = 0.0;
    if (moves_on)
      step = between(path.metric[i - 1], path.metric[i], 0.5).length(path.points[i] - path.points[i - 1]);
    const bool inside = moves_on && (near[i] || near[i - 1]);
    const int parts = inside ? std::max(1, static_cast<int>(std::ceil(step / grain))) : 1;
    if (i > 0 && !moves_on)
      dense.passes.push_back(dense.points.size());
    for (int k = moves_on ? 1 : parts; k <= parts; ++k) {
      const double share = static_cast<double>(k) / parts;
      const std::size_t before = moves_on ? i - 1 : i;
      dense.points.push_back((1.0 - share) * path.points[before] + share * path.points[i]);
      dense.metric.push_back(between(path.metric[before], path.metric[i], share));
      dense.reversed.push_back(path.reversed[i]);
      dense.turns.push_back(path.turns[before] + static_cast<float>(share) * (path.turns[i] - path.turns[before]));
      dense_near.push_back(near[i] || inside);
      moves.push_back(dense_near.back() && travelled + share * step > held);
    }
    places.push_back(dense.points.size() - 1);
    travelled += step;
  }
  places.push_back(dense.points.size());
  path.points = std::move(dense.points);
  path.metric = std::move(dense.metric);
  path.reversed = std::move(dense.reversed);
  path.turns = std::move(dense.turns);
  path.passes = std::move(dense.passes);
}

} // namespace pcl_spiral
