// SPDX-License-Identifier: BSD-3-Clause
// The box of what stands beside the part, which rapids cross above.
#include <pcl_spiral/collision/impl/false_echoes.h>
#include <pcl_spiral/planning/pass_plan.h>
#include <pcl_spiral/planning/spiral_plan.h>

#include <pcl/common/point_tests.h>

namespace pcl_spiral {
namespace {

/** Whether more stands in the scan than the part. */
bool
isChosen(const ChosenPart& part, bool largest_part, std::size_t regions)
{
  return part.cloud || part.part_at || largest_part || regions > 0;
}

Eigen::AlignedBox3d
boxWithoutEchoes(const pcl::PointCloud<pcl::PointXYZ>& scan)
{
  std::vector<Eigen::Vector3f> points;
  for (const pcl::PointXYZ& p : scan)
    if (pcl::isFinite(p))
      points.push_back(p.getVector3fMap());
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3f& p : withoutEchoes(points, largest_echo))
    box.extend(p.cast<double>());
  return box;
}

} // namespace

Eigen::AlignedBox3d
SpiralPlan::clearBox() const
{
  return whole && isChosen(part, settings.largest_part, regions.size()) ? boxWithoutEchoes(*whole) : Eigen::AlignedBox3d();
}

Eigen::AlignedBox3d
PassPlan::clearBox() const
{
  const bool largest_part = surface && surface->settings().largest_part;
  return whole && !mesh && (!covers_scan || isChosen(chosen, largest_part, regions.size())) ? boxWithoutEchoes(*whole)
                                                                                            : Eigen::AlignedBox3d();
}

} // namespace pcl_spiral
