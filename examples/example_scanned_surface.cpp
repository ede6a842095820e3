// SPDX-License-Identifier: BSD-3-Clause
// Makes a surface from a raw scan of a dome once; two stages use it. It reports the points left out and the reasons.
#include <pcl_spiral/features/boundary_loops.h>
#include <pcl_spiral/surface/mls_projector.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <random>

int
main()
{
  pcl::PointCloud<pcl::PointXYZ>::Ptr scan(new pcl::PointCloud<pcl::PointXYZ>);
  std::mt19937 random(1);
  std::uniform_real_distribution<float> side(-80.0f, 80.0f);
  for (int i = 0; i < 20000; ++i) {
    const float x = side(random), y = side(random), z = std::sqrt(200.0f * 200.0f - x * x - y * y);
    scan->emplace_back(x, y, z);
    if (i % 500 == 0)
      scan->emplace_back(x, y, z); // a duplicate
    if (i % 1000 == 0)
      scan->emplace_back(x, y, std::numeric_limits<float>::quiet_NaN());
    if (i % 2000 == 0)
      scan->emplace_back(x, y, z + 10.0f); // an outlier
  }

  pcl_spiral::ScannedSurface<pcl::PointXYZ> scanned;
  scanned.setInputCloud(scan);
  scanned.setViewPoint(Eigen::Vector3d(0.0, 0.0, 1000.0)); // position of the scanner
  pcl_spiral::Surface::ConstPtr surface;
  scanned.compute(surface);
  if (!surface)
    return 1; // the class has reported the error; scanned.getStatus() has it too

  const pcl_spiral::SurfaceReport& counts = surface->report();
  std::printf("%zu points: %zu not finite, %zu repeated, %zu isolated, %zu in clusters, %zu surplus, %zu used\n", counts.input,
              counts.nonfinite, counts.duplicate, counts.isolated, counts.clustered, counts.surplus, counts.used);
  for (const Eigen::Vector3f& place : surface->leftOut().positions)
    std::printf("  left out: (%.1f, %.1f, %.1f)\n", place.x(), place.y(), place.z());
  std::printf("spacing %.3f mm, noise %.5f mm\n", surface->spacing(), surface->noise());

  pcl_spiral::BoundaryLoops<pcl::PointXYZ> boundaries;
  boundaries.setInputSurface(surface);
  std::vector<pcl_spiral::BoundaryLoop> loops;
  boundaries.compute(loops);

  pcl_spiral::MLSProjector<pcl::PointXYZ, pcl::PointNormal> projector; // projects the points of the surface, without other points
  projector.setInputSurface(surface);
  pcl::PointCloud<pcl::PointNormal> feet;
  projector.compute(feet);
  if (loops.empty() || feet.empty())
    return 1;
  std::printf("rim of %.2f mm; the first point's curvature is 1 / %.2f mm\n", loops.front().length, 1.0 / feet[0].curvature);
  return 0;
}
