// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/verify/impl/false_echoes.h>

#include <pcl_spiral/cleaning/stray_removal.h>

#include <omp.h>

namespace pcl_spiral {

std::vector<Eigen::Vector3f>
withoutEchoes(const std::vector<Eigen::Vector3f>& points, std::size_t largest)
{
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const Eigen::Vector3f& point : points)
    cloud->emplace_back(point.x(), point.y(), point.z());
  StrayRemoval<pcl::PointXYZ> removal;
  removal.setLargestGroup(largest);
  removal.setNumberOfThreads(static_cast<unsigned int>(omp_get_max_threads()));
  removal.setInputCloud(cloud);
  pcl::Indices kept;
  removal.filter(kept);
  if (!removal.getStatus().ok())
    return points;
  std::vector<Eigen::Vector3f> others;
  for (const auto i : kept)
    others.push_back(points[static_cast<std::size_t>(i)]);
  return others;
}

} // namespace pcl_spiral
