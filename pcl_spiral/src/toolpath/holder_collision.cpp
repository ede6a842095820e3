#include <pcl_spiral/toolpath/holder_collision.h>

namespace pcl_spiral {

HolderCollision
findCollision(const PointBlocks& blocks, const HolderProfile& holder, const AxisFrame& frame, double tip,
              double tolerance)
{
  HolderCollision worst;
  if (holder.empty())
    return worst;
  constexpr double slack = 1e-9;
  const Eigen::Vector3d a1 = frame.e1.cwiseAbs(), a2 = frame.e2.cwiseAbs(), a3 = frame.axis.cwiseAbs();
  const double low = tip + holder.bottom() - slack, high = tip + holder.top() + slack;
  const auto keep = [&](const Box& box) {
    const Eigen::Vector3d lower(box.low[0], box.low[1], box.low[2]),
        upper(box.high[0], box.high[1], box.high[2]);
    const Eigen::Vector3d half = 0.5 * (upper - lower), middle = 0.5 * (upper + lower);
    const double along = frame.along(middle), reach = half.dot(a3);
    if (along + reach < low || along - reach > high)
      return false;
    const Eigen::Vector2d x = frame.across(middle);
    const double dx = std::max(0.0, std::abs(x.x()) - half.dot(a1));
    const double dy = std::max(0.0, std::abs(x.y()) - half.dot(a2));
    return std::sqrt(dx * dx + dy * dy) <= holder.radius() + slack;
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
