// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/cutter/impl/holder_collision.h>

namespace pcl_spiral {

HolderCollision
findCollision(const PointBlocks& blocks, const HolderProfile& holder, const AxisFrame& frame, double tip, double tolerance)
{
  HolderCollision worst;
  if (holder.empty())
    return worst;
  constexpr double slack = 1e-9;
  const AxisView view(frame);
  const double low = tip + holder.bottom() - slack, high = tip + holder.top() + slack;
  const auto keep = [&](const Box& box) {
    const AxisBox seen = view.see(box);
    return seen.high >= low && seen.low <= high && seen.nearest <= holder.radius() + slack;
  };
  double deepest = tolerance;
  blocks.forBlocks(keep, [&](std::size_t block) {
    for (std::size_t i = blocks.blockBegin(block); i < blocks.blockEnd(block); ++i) {
      const Eigen::Vector3d p = blocks.position(i);
      double depth = 0.0;
      const int segment = holder.inside(frame.across(p).norm(), frame.along(p) - tip, depth);
      if (segment < 0 || !(depth > deepest))
        continue;
      deepest = depth;
      worst = {segment, depth, p, blocks.originalIndex(i)};
    }
  });
  return worst;
}

} // namespace pcl_spiral
