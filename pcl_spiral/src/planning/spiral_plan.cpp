// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/planning/spiral_plan.h>

#include <pcl_spiral/collision/impl/false_echoes.h>

#include <pcl/common/point_tests.h>

namespace pcl_spiral {

Eigen::AlignedBox3d
SpiralPlan::clearBox() const
{
  Eigen::AlignedBox3d box;
  if (!whole || (!part.cloud && !part.part_at && regions.empty()))
    return box;
  std::vector<Eigen::Vector3f> points;
  for (const pcl::PointXYZ& p : *whole)
    if (pcl::isFinite(p))
      points.push_back(p.getVector3fMap());
  for (const Eigen::Vector3f& p : withoutEchoes(points, largest_echo))
    box.extend(p.cast<double>());
  return box;
}

} // namespace pcl_spiral
