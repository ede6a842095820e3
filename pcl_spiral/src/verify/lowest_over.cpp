// SPDX-License-Identifier: BSD-3-Clause
#include "lowest_over.h"

#include "tangent_search.h"

#include <cmath>
#include <limits>

namespace pcl_spiral {

SurfaceHeight
lowestOver(const ProfileDepth& profile, const Eigen::Vector3d& tip, const Eigen::Vector3d& axis, const SurfaceFoot& foot, double reach)
{
  constexpr int cells = 4; // of the first places along each side
  constexpr double none = -std::numeric_limits<double>::infinity(), settled = 1e-7;
  const double k1 = foot.curvature1, k2 = foot.curvature2, half = reach * std::sqrt(0.5);
  const Eigen::Vector3d &n = foot.normal, &e1 = foot.direction1, e2 = n.cross(e1);
  SurfaceHeight lowest{-none, foot.position};
  const auto at = [&](double a, double b) { // value, slope along b, slope along a
    const Eigen::Vector3d place = foot.position + a * e1 + b * e2 - 0.5 * (k1 * a * a + k2 * b * b) * n;
    const Eigen::Vector3d w = place - tip;
    const double z = w.dot(axis), l = std::sqrt(std::max(0.0, w.squaredNorm() - z * z));
    const ProfileDepth::Side side = profile.at(l, z);
    const Eigen::Vector3d out = side.across / std::max(l, 1e-12) * (w - z * axis) + side.along * axis;
    if (-side.depth < lowest.height)
      lowest = {-side.depth, place};
    return Tangent{side.depth, -out.dot(e2 - k2 * b * n), -out.dot(e1 - k1 * a * n)};
  };
  at(0.0, 0.0);
  if (!(reach > 0.0))
    return lowest;
  for (int i = -cells / 2; i <= cells / 2; ++i) // in a hollow there may be two
    for (int j = -cells / 2; j <= cells / 2; ++j)
      at(2.0 * half * i / cells, 2.0 * half * j / cells);
  const auto over = [&](double a) {
    const Tangent most = largestOf([&](double b) { return at(a, b); }, -half, half, none, settled);
    return Tangent{most.value, most.other, 0.0};
  };
  largestOf(over, -half, half, none, settled);
  return lowest;
}

} // namespace pcl_spiral
