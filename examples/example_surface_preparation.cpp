// SPDX-License-Identifier: BSD-3-Clause
// Prepares a raw scan of a dome, with outliers, duplicates and NaN, for the other stages.
#include <pcl_spiral/surface/surface_preparation.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <random>

int
main()
{
  std::mt19937 random(1);
  std::uniform_real_distribution<float> side(-80.0f, 80.0f);
  pcl::PointCloud<pcl::PointXYZ>::Ptr scan(new pcl::PointCloud<pcl::PointXYZ>);
  for (int i = 0; i < 20000; ++i) {
    const float x = side(random), y = side(random);
    scan->push_back(pcl::PointXYZ(x, y, std::sqrt(200.0f * 200.0f - x * x - y * y)));
    if (i % 500 == 0)
      scan->push_back(scan->back());
    if (i % 1000 == 0)
      scan->push_back(pcl::PointXYZ(x, y, std::numeric_limits<float>::quiet_NaN()));
    if (i % 4000 == 0)
      scan->push_back(pcl::PointXYZ(x, y, 260.0f));
  }

  pcl_spiral::SurfacePreparation<pcl::PointXYZ> preparation;
  preparation.setInputCloud(scan);
  preparation.setOutlierRemoval(16, 6.0);
  preparation.setThinning(1.0);                            // mm
  preparation.setViewPoint(Eigen::Vector3d(0, 0, 1000.0)); // position of the scanner
  pcl::PointCloud<pcl::PointXYZ> cloud;
  pcl::PointCloud<pcl::Normal> normals;
  preparation.compute(cloud, normals);
  if (!preparation.getStatus().ok())
    return 1;

  const pcl_spiral::SurfaceReport& counts = preparation.getReport();
  std::printf("%zu points: %zu not finite, %zu repeated, %zu outliers, %zu thinned, %zu used; spacing %.3f mm\n", counts.input,
              counts.nonfinite, counts.duplicate, counts.outlier, counts.thinned, counts.used, preparation.getSurface()->spacing());
  for (std::size_t i = 0; i < cloud.size(); i += cloud.size() / 5)
    std::printf("point %8.3f %8.3f %8.3f  normal %6.3f %6.3f %6.3f  input point %u\n", cloud[i].x, cloud[i].y, cloud[i].z,
                normals[i].normal_x, normals[i].normal_y, normals[i].normal_z, preparation.getSourceIndices()[i]);
  return 0;
}
