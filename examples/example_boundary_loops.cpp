// SPDX-License-Identifier: BSD-3-Clause
// The boundary loops of a cloud: a square of random points with a hole and a gap in the data, or a PCD file.
#include <pcl_spiral/features/boundary_loops.h>

#include <pcl/io/pcd_io.h>

#include <cmath>
#include <cstdio>
#include <random>

int
main(int argc, char** argv)
{
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  if (argc > 1) {
    if (pcl::io::loadPCDFile(argv[1], *cloud) != 0)
      return 1;
  }
  else {
    std::mt19937 random(1);
    const auto coordinate = [&] { return 100.0f * static_cast<float>(random() >> 8) / static_cast<float>(1 << 24); };
    while (cloud->size() < 20000) {
      const float x = coordinate(), y = coordinate();
      if (std::hypot(x - 40.0f, y - 40.0f) > 18.0f && std::hypot(x - 80.0f, y - 75.0f) > 4.0f)
        cloud->emplace_back(x, y, 0.001f * x * y);
    }
  }

  pcl_spiral::BoundaryLoops<pcl::PointXYZ> boundary;
  boundary.setInputCloud(cloud);
  std::vector<pcl_spiral::BoundaryLoop> loops;
  boundary.compute(loops);
  if (!boundary.getStatus().ok())
    return 1;

  for (const pcl_spiral::BoundaryLoop& loop : loops) {
    const char* type = loop.type == pcl_spiral::LoopType::Outer ? "outer" : loop.type == pcl_spiral::LoopType::Inner ? "inner" : "scan gap";
    std::printf("%-8s  length %8.2f mm, %zu points, curve of %zu, %zu corners\n", type, loop.length, loop.points.size(), loop.curve.size(),
                loop.corners.size());
  }

  // Given boundary points, for example from CentroidBoundaryEstimation; here the points of the outer loop, to be linked.
  pcl::PointCloud<pcl::Boundary>::Ptr marked(new pcl::PointCloud<pcl::Boundary>(cloud->size(), 1));
  for (const std::uint32_t index : loops.front().indices)
    (*marked)[index].boundary_point = 1;
  boundary.setBoundaryPoints(marked);
  boundary.setLoopMethod(pcl_spiral::LoopMethod::Walk);
  boundary.compute(loops);
  if (boundary.getStatus().ok())
    std::printf("walked    length %8.2f mm, %zu points\n", loops.front().length, loops.front().points.size());
  return boundary.getStatus().ok() ? 0 : 1;
}
