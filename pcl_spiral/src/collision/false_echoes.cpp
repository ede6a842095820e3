// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/collision/impl/false_echoes.h>

#include <pcl_spiral/cleaning/outlier_removal.h>

#include <omp.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <set>

namespace pcl_spiral {

std::vector<Eigen::Vector3f>
withoutEchoes(const std::vector<Eigen::Vector3f>& points, std::size_t largest)
{
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const Eigen::Vector3f& point : points)
    cloud->emplace_back(point.x(), point.y(), point.z());
  OutlierRemoval<pcl::PointXYZ> removal;
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

std::vector<Eigen::Vector3f>
withoutEchoes(const std::vector<Eigen::Vector3f>& points, const pcl::PointCloud<pcl::PointXYZ>& scan)
{
  std::vector<Eigen::Vector3f> all, others;
  for (const pcl::PointXYZ& p : scan)
    all.push_back(p.getVector3fMap());
  std::set<std::array<float, 3>> echoes;
  for (const Eigen::Vector3f& p : all)
    echoes.insert({p.x(), p.y(), p.z()});
  for (const Eigen::Vector3f& p : withoutEchoes(all, largest_echo))
    echoes.erase({p.x(), p.y(), p.z()});
  std::copy_if(points.begin(), points.end(), std::back_inserter(others), [&](const Eigen::Vector3f& p) {
    return echoes.count({p.x(), p.y(), p.z()}) == 0;
  });
  return others;
}

} // namespace pcl_spiral
