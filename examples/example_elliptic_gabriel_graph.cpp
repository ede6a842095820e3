// SPDX-License-Identifier: BSD-3-Clause
// Neighbour graph of a random cloud on a plane, at three axis ratios: the mean degree is 4 / alpha.
#include <pcl_spiral/search/elliptic_gabriel_graph.h>

#include <cstdio>
#include <random>

int
main()
{
  std::mt19937 random(1);
  std::uniform_real_distribution<float> side(0.0f, 100.0f);
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  for (int i = 0; i < 50000; ++i)
    cloud->push_back(pcl::PointXYZ(side(random), side(random), 0.0f));

  pcl_spiral::EllipticGabrielGraph<pcl::PointXYZ> egg;
  egg.setInputCloud(cloud);
  for (double alpha : {1.0, 0.75, 0.5}) {
    egg.setAlpha(alpha);
    pcl_spiral::NeighbourLists graph;
    egg.compute(graph);
    if (!egg.getStatus().ok())
      return 1;
    std::printf("alpha %.2f: %zu edges, mean degree %.3f (4 / alpha = %.3f), neighbours of point 0:", alpha, graph.edgeCount(),
                2.0 * static_cast<double>(graph.edgeCount()) / static_cast<double>(graph.size()), 4.0 / alpha);
    for (const auto neighbour : graph[0])
      std::printf(" %u", neighbour);
    std::printf("\n");
  }
  return 0;
}
