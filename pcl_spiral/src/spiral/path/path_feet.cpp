// SPDX-License-Identifier: BSD-3-Clause
#include "path_feet.h"

#include <cstdint>
#include <limits>

namespace pcl_spiral {
namespace {

constexpr int widest = 4;
constexpr double largest_overhang = 1.25; // spacings: the same as in the fit
constexpr double farthest = 4.0;          // spacings from the nearest point

} // namespace

void
pathFeet(const Surface& surface, const Polyline& points, std::vector<SurfaceFoot>& feet)
{
  surface.fit().project(points, feet, widest);
  const auto count = static_cast<std::int64_t>(points.size());
#pragma omp parallel for schedule(dynamic, 1024)
  for (std::int64_t i = 0; i < count; ++i) {
    SurfaceFoot& foot = feet[i];
    if (foot.valid || foot.overhang > largest_overhang * surface.spacing())
      continue;
    const std::uint32_t nearest = surface.graph().blocks().nearest(points[i]);
    if ((surface.position(nearest) - points[i]).norm() > farthest * surface.spacing())
      continue;
    foot = SurfaceFoot();
    foot.position = points[i];
    foot.normal = surface.normal(nearest);
    foot.direction1 = foot.normal.unitOrthogonal();
    foot.nearest = nearest;
    foot.nearest_distance = std::numeric_limits<double>::infinity();
    foot.valid = true;
  }
}

} // namespace pcl_spiral
