// SPDX-License-Identifier: BSD-3-Clause
// A noisy cloud of a sphere of radius 100 mm, projected onto its surface: distances from the sphere before and after,
// and the curvature radii found.
#include <pcl_spiral/surface/mls_projector.h>

#include <cmath>
#include <cstdio>
#include <random>

int
main()
{
  std::mt19937 random(1);
  std::normal_distribution<float> normal;
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  while (cloud->size() < 40000) {
    const Eigen::Vector3f direction = Eigen::Vector3f(normal(random), normal(random), normal(random)).normalized();
    if (direction.z() < 0.4f)
      continue;
    const Eigen::Vector3f p = (100.0f + 0.02f * normal(random)) * direction;
    cloud->push_back(pcl::PointXYZ(p.x(), p.y(), p.z()));
  }

  pcl_spiral::MLSProjector<pcl::PointXYZ, pcl::PointNormal> projector;
  projector.setInputCloud(cloud);
  pcl::PointCloud<pcl::PointNormal> projected;
  projector.compute(projected);
  if (!projector.getStatus().ok())
    return 1;

  double before = 0.0, after = 0.0, curvature = 0.0, count = 0.0;
  for (std::size_t i = 0; i < projected.size(); ++i) {
    if (!projector.getValid()[i])
      continue;
    before += std::pow((*cloud)[i].getVector3fMap().norm() - 100.0, 2);
    after += std::pow(projected[i].getVector3fMap().norm() - 100.0, 2);
    curvature += projected[i].curvature;
    ++count;
  }
  std::printf("noise found %.4f mm, %d neighbours in a fit\n", projector.getNoise(), projector.getNeighboursUsed());
  std::printf("off the sphere, rms: %.4f mm before, %.4f mm after; mean curvature radius %.2f mm\n", std::sqrt(before / count),
              std::sqrt(after / count), count / curvature);
  return 0;
}
