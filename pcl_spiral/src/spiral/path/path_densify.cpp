// SPDX-License-Identifier: BSD-3-Clause
#include "path_densify.h"

#include "core/parallel_resize.h"
#include <pcl_spiral/core/impl/pass_ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_spiral {

void
densify(const std::vector<std::uint8_t>& near, double held, double grain, LinkedPath& path, std::vector<std::uint8_t>& moves,
        std::vector<std::size_t>& places)
{
  const auto count = static_cast<std::int64_t>(path.points.size());
  const auto before = [&](std::size_t i) { return i > 0 && !beginsPass(path.passes, i) ? i - 1 : i; }; // itself where a pass begins
  const auto stepTo = [&](std::size_t i) {
    const std::size_t b = before(i);
    return b == i ? 0.0 : between(path.metric[b], path.metric[i], 0.5).length(path.points[i] - path.points[b]);
  };
  const auto isInside = [&](std::size_t i) { return before(i) != i && (near[i] || near[i - 1]); };
  std::vector<double> travelled(path.points.size()); // to the point before
  places.resize(path.points.size() + 1);
#pragma omp parallel for schedule(static, 4096)
  for (std::int64_t i = 0; i < count; ++i) {
    travelled[i] = stepTo(i);
    places[i] = isInside(i) ? std::max(1, static_cast<int>(std::ceil(travelled[i] / grain))) : 1;
  }
  double way = 0.0;
  std::size_t all = 0;
  for (std::int64_t i = 0; i < count; ++i) {
    way += std::exchange(travelled[i], way);
    places[i] = (all += places[i]) - 1;
  }
  places.back() = all;
  LinkedPath dense;
  resizeInParallel(dense.points, all);
  resizeInParallel(dense.metric, all);
  dense.reversed.resize(all);
  dense.turns.resize(all);
  moves.resize(all);
#pragma omp parallel for schedule(static, 4096)
  for (std::int64_t i = 0; i < count; ++i) {
    const std::size_t b = before(i), first = i > 0 ? places[i - 1] + 1 : 0, parts = places[i] + 1 - first;
    const double step = stepTo(i);
    for (std::size_t k = first; k <= places[i]; ++k) {
      const double share = static_cast<double>(k + 1 - first) / static_cast<double>(parts);
      dense.points[k] = (1.0 - share) * path.points[b] + share * path.points[i];
      dense.metric[k] = between(path.metric[b], path.metric[i], share);
      dense.reversed[k] = path.reversed[i];
      dense.turns[k] = path.turns[b] + static_cast<float>(share) * (path.turns[i] - path.turns[b]);
      moves[k] = (near[i] || isInside(i)) && travelled[i] + share * step > held;
    }
  }
  for (std::size_t& begin : path.passes)
    begin = places[begin];
  path.points = std::move(dense.points);
  path.metric = std::move(dense.metric);
  path.reversed = std::move(dense.reversed);
  path.turns = std::move(dense.turns);
}

} // namespace pcl_spiral
