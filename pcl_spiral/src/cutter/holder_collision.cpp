// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/cutter/impl/holder_collision.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {

double
farthestCorner(const Box& box, const Eigen::Vector3d& place)
{
  Eigen::Vector3d way;
  for (int d = 0; d < 3; ++d)
    way[d] = std::max(std::abs(place[d] - box.low[d]), std::abs(place[d] - box.high[d]));
  return way.norm();
}

HolderCollision
findCollision(const PointBlocks& blocks, const HolderProfile& holder, const AxisFrame& frame, double tip, double tolerance, double above)
{
  HolderCollision worst;
  if (holder.empty())
    return worst;
  constexpr double slack = 1e-9;
  const AxisView view(frame);
  double deepest = tolerance;
  const auto keep = [&](const Box& box) {
    const AxisBox seen = view.see(box);
    double depth = 0.0;
    const double low = std::max(seen.low, above) - tip - slack, high = seen.high - tip + slack;
    return high >= low && holder.mayBeInside(seen.nearest - slack, low, high, depth) >= 0 && depth + slack > deepest;
  };
  blocks.forBlocks(keep, [&](std::size_t block) {
    for (std::size_t i = blocks.blockBegin(block); i < blocks.blockEnd(block); ++i) {
      const Eigen::Vector3d p = blocks.position(i);
      const double along = frame.along(p);
      double depth = 0.0;
      const int segment = along > above ? holder.inside(frame.across(p).norm(), along - tip, depth) : -1;
      if (segment < 0 || !(depth > deepest))
        continue;
      deepest = depth;
      worst = {ToolPart::Holder, segment, depth, p, blocks.originalIndex(i)};
    }
  });
  return worst;
}

bool
mayCollide(const PointBlocks& blocks, const HolderProfile& holder, const AxisFrame& frame, const ToolSway& sway, double tolerance)
{
  constexpr double slack = 1e-9;
  const AxisView view(frame);
  bool met = false;
  const auto isDeep = [&](double nearest, double low, double high, double reach) {
    double depth = 0.0;
    return holder.mayBeInside(std::max(0.0, nearest - reach), low - reach, high + reach, depth) >= 0 && depth > tolerance;
  };
  const auto keep = [&](const Box& box) {
    if (met)
      return false;
    const AxisBox seen = view.see(box);
    return isDeep(seen.nearest, seen.low, seen.high, sway.at(farthestCorner(box, frame.origin)) + slack);
  };
  blocks.forBlocks(keep, [&](std::size_t block) {
    for (std::size_t i = blocks.blockBegin(block); i < blocks.blockEnd(block) && !met; ++i) {
      const Eigen::Vector3d p = blocks.position(i);
      const double along = frame.along(p);
      met = isDeep(frame.across(p).norm(), along, along, sway.at((p - frame.origin).norm()) + slack);
    }
  });
  return met;
}

} // namespace pcl_spiral
