// SPDX-License-Identifier: BSD-3-Clause
// Uses the classes with a point type of its own, from a project with C in it.
#include "scanner_point.h"

#include <pcl_spiral/features/centroid_boundary_estimation.h>
#include <pcl_spiral/search/elliptic_gabriel_graph.h>

#include <cmath>
#include <iostream>

extern "C" double metres_to_millimetres(double metres);

/** A dome about the origin, its points on a sunflower. */
ScannerCloud::Ptr
scanOfDome(int count, double radius, double rim)
{
  ScannerCloud::Ptr cloud(new ScannerCloud);
  for (int i = 0; i < count; ++i) {
    const double r = rim * std::sqrt((i + 0.5) / count), angle = 2.399963229728653 * i;
    ScannerPoint point;
    point.getVector3fMap() = Eigen::Vector3d(r * std::cos(angle), r * std::sin(angle), std::sqrt(radius * radius - r * r)).cast<float>();
    point.confidence = 1.0f;
    cloud->push_back(point);
  }
  return cloud;
}

/** Every edge both ways, and as many as on a surface. */
bool
graphIsRight(const ScannerCloud::Ptr& cloud)
{
  pcl_spiral::EllipticGabrielGraph<ScannerPoint> egg;
  egg.setInputCloud(cloud);
  pcl_spiral::NeighbourLists graph;
  egg.compute(graph);
  if (!egg.getStatus().ok())
    return false;
  bool symmetric = true;
  for (std::uint32_t i = 0; i < graph.size(); ++i)
    for (const std::uint32_t j : graph[i])
      symmetric = symmetric && graph.contains(j, i);
  const double degree = 2.0 * graph.edgeCount() / graph.size();
  std::cout << "c_and_cxx: mean degree " << degree << " on points of our own\n";
  return symmetric && degree > 4 && degree < 8;
}

/** Boundary points at the rim alone, all around. */
bool
boundaryIsRight(const ScannerCloud::Ptr& cloud, double rim)
{
  pcl::PointCloud<pcl::Normal>::Ptr normals(new pcl::PointCloud<pcl::Normal>);
  for (const ScannerPoint& point : *cloud) {
    const Eigen::Vector3f n = point.getVector3fMap().normalized();
    normals->emplace_back(n.x(), n.y(), n.z());
  }
  pcl_spiral::CentroidBoundaryEstimation<ScannerPoint, pcl::Normal> estimation;
  estimation.setInputCloud(cloud);
  estimation.setInputNormals(normals);
  estimation.setKSearch(32);
  pcl::PointCloud<pcl::Boundary> boundary;
  estimation.compute(boundary);
  const double spacing = rim * std::sqrt(M_PI / cloud->size());
  std::size_t found = 0, inside = 0;
  for (std::size_t i = 0; i < boundary.size(); ++i)
    if (boundary[i].boundary_point) {
      found += 1;
      inside += std::hypot((*cloud)[i].x, (*cloud)[i].y) < rim - 3 * spacing;
    }
  std::cout << "c_and_cxx: " << found << " boundary points, " << inside << " of them inside\n";
  return found > 2 * M_PI * rim / spacing / 2 && inside == 0;
}

int
main()
{
  const double radius = metres_to_millimetres(0.08), rim = 48;
  const auto cloud = scanOfDome(5000, radius, rim);
  return graphIsRight(cloud) && boundaryIsRight(cloud, rim) && stagesAreRight(cloud, radius, rim) ? 0 : 1;
}
