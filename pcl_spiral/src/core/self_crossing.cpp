// SPDX-License-Identifier: BSD-3-Clause
#include "self_crossing.h"

#include "core/move_pairs.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace pcl_spiral {
namespace {

constexpr std::int64_t chunk = 1 << 16; // segments between two calls of go_on

} // namespace

std::optional<std::size_t>
firstSelfCrossing(const Polyline& path, const std::vector<Eigen::Vector3d>& normals, double slack, const std::function<bool(double)>& go_on,
                  const std::vector<std::size_t>& passes)
{
  if (path.size() < 4)
    return std::nullopt;
  const MovePairs pairs(path, normals, slack, passes);
  const std::int64_t segments = pairs.size();
  auto first = std::numeric_limits<std::int64_t>::max();
  for (std::int64_t begin = 0; begin < segments && first > segments; begin += chunk) {
    if (go_on && !go_on(static_cast<double>(begin) / static_cast<double>(segments)))
      return std::nullopt;
    const std::int64_t end = std::min(begin + chunk, segments);
#pragma omp parallel for schedule(dynamic, 1024) reduction(min : first)
    for (std::int64_t i = begin; i < end; ++i)
      if (i < first && !pairs.isLift(static_cast<std::size_t>(i)))
        pairs.forLater(static_cast<std::size_t>(i), 0.0, [&](const MovePair& pair) {
          if (pair.mayCross() && pairs.cross(pair.first, pair.later))
            first = i;
        });
  }
  return first < segments ? std::optional<std::size_t>(static_cast<std::size_t>(first)) : std::nullopt;
}

} // namespace pcl_spiral
