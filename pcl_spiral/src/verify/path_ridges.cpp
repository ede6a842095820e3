// SPDX-License-Identifier: BSD-3-Clause
#include "path_ridges.h"

#include <pcl/kdtree/kdtree_flann.h>

#include <cmath>
#include <limits>

namespace pcl_spiral {

std::vector<float>
ridgesAlong(const pcl::PointCloud<ToolpathPoint>& path, const pcl::PointCloud<pcl::PointXYZI>& stock, const std::vector<float>& ridges)
{
  std::vector<float> along(path.size(), std::numeric_limits<float>::quiet_NaN());
  const auto surface = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  std::vector<float> surface_ridges;
  for (std::size_t i = 0; i < stock.size(); ++i)
    if (!std::isnan(stock[i].intensity)) {
      surface->emplace_back(stock[i].x, stock[i].y, stock[i].z);
      surface_ridges.push_back(ridges[i]);
    }
  if (surface->empty())
    return along;
  pcl::KdTreeFLANN<pcl::PointXYZ> tree;
  tree.setInputCloud(surface);
  pcl::Indices nearest(1);
  std::vector<float> squared(1);
  for (std::size_t i = 0; i < path.size(); ++i)
    if (tree.nearestKSearch(pcl::PointXYZ(path[i].x, path[i].y, path[i].z), 1, nearest, squared) == 1)
      along[i] = surface_ridges[static_cast<std::size_t>(nearest[0])];
  return along;
}

} // namespace pcl_spiral
