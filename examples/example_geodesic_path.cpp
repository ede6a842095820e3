// SPDX-License-Identifier: BSD-3-Clause
// Shortest paths over a dome from a point near its top to six points of its rim.
#include <pcl_spiral/geodesic/geodesic_path.h>

#include <cmath>
#include <cstdio>
#include <random>

int
main()
{
  const double a = 165.0, b = 86.0; // semi-axes, mm
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform;
  while (cloud->size() < 40000) {
    const double t = std::acos(uniform(random)), longitude = 2.0 * M_PI * uniform(random);
    const double r = a * std::sin(t), weight = std::hypot(a * std::cos(t), b * std::sin(t)) / a;
    if (uniform(random) < weight) // as many points to an area everywhere
      cloud->emplace_back(static_cast<float>(r * std::cos(longitude)), static_cast<float>(r * std::sin(longitude)),
                          static_cast<float>(b * std::cos(t)));
  }

  pcl_spiral::Polyline rim;
  for (int k = 0; k < 6; ++k)
    rim.emplace_back(a * std::cos(k * M_PI / 5.0), a * std::sin(k * M_PI / 5.0), 0.0);

  pcl_spiral::GeodesicPath<pcl::PointXYZ> geodesic;
  geodesic.setInputCloud(cloud);
  geodesic.setSourcePoint({a * std::sin(0.5), 0.0, b * std::cos(0.5)});
  geodesic.setTargetPoints(rim);
  std::vector<pcl::PointCloud<pcl::PointXYZ>> paths;
  geodesic.compute(paths);
  if (!geodesic.getStatus().ok())
    return 1;

  for (std::size_t k = 0; k < paths.size(); ++k)
    std::printf("to (%7.2f %7.2f): %8.4f mm, %zu points\n", rim[k].x(), rim[k].y(), geodesic.getLengths()[k], paths[k].size());
  return 0;
}
