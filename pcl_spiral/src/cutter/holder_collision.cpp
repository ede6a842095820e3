// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/cutter/impl/holder_collision.h>

#include <algorithm>

namespace pcl_spiral {

HolderCollision
findCollision(const PointBlocks& blocks, const HolderProfile& holder, const AxisFrame& frame, double tip, double tolerance, double above)
{
  HolderCollision worst;
  if (holder.empty())
    return worst;
  constexpr double slack = 1e-9;
  const AxisView view(frame);
  const double low = std::max(tip + holder.bottom(), above) - slack, high = tip + holder.top() + slack;
  const auto keep = [&](const Box& box) {
    const AxisBox seen = view.see(box);
    return seen.high >= low && seen.low <= high && seen.nearest <= holder.radius() + slack;
  };
  double deepest = tolerance;
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

} // namespace pcl_spiral
