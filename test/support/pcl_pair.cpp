// SPDX-License-Identifier: BSD-3-Clause
#include "support/pcl_pair.h"

#include <pcl/features/boundary.h>
#include <pcl/features/normal_3d_omp.h>

#include <chrono>

namespace pcl_spiral::test {

NormalCloud::Ptr
pclNormals(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& cloud, const Tree::Ptr& tree, int threads)
{
  NormalCloud::Ptr normals(new NormalCloud);
  pcl::NormalEstimationOMP<pcl::PointXYZ, pcl::Normal> estimation(static_cast<unsigned>(threads));
  estimation.setInputCloud(cloud);
  estimation.setSearchMethod(tree);
  estimation.setKSearch(20);
  estimation.compute(*normals);
  return normals;
}

pcl::PointCloud<pcl::Boundary>
pclBoundary(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& cloud, const NormalCloud::ConstPtr& normals, const Tree::Ptr& tree)
{
  pcl::PointCloud<pcl::Boundary> marks;
  pcl::BoundaryEstimation<pcl::PointXYZ, pcl::Normal, pcl::Boundary> estimation;
  estimation.setInputCloud(cloud);
  estimation.setInputNormals(normals);
  estimation.setSearchMethod(tree);
  estimation.setKSearch(30);
  estimation.compute(marks);
  return marks;
}

PairSeconds
timePclPair(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& cloud, int threads)
{
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  const Tree::Ptr tree(new Tree);
  const NormalCloud::Ptr normals = pclNormals(cloud, tree, threads);
  const auto middle = Clock::now();
  pclBoundary(cloud, normals, tree);
  const auto end = Clock::now();
  return {std::chrono::duration<double>(middle - begin).count(), std::chrono::duration<double>(end - middle).count()};
}

} // namespace pcl_spiral::test
