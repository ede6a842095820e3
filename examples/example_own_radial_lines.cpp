// SPDX-License-Identifier: BSD-3-Clause
// An own stage: radial lines by a formula, meridians of a sphere, instead of the geodesics of RadialLines.
#include <pcl_spiral/core/bspline_fit.h>
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>

#include <cmath>
#include <cstdio>
#include <random>

using namespace pcl_spiral;

int
main()
{
  const double radius = 150.0, reach = 0.5; // of the sphere, mm; of its cap, from the pole, in radians
  const auto at = [&](double polar, double azimuth) -> Eigen::Vector3d {
    return {radius * std::sin(polar) * std::cos(azimuth), radius * std::sin(polar) * std::sin(azimuth), radius * std::cos(polar)};
  };
  pcl::PointCloud<pcl::PointXYZ>::Ptr scan(new pcl::PointCloud<pcl::PointXYZ>);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  while (scan->size() < 20000) {
    const Eigen::Vector3d p = at(reach * std::sqrt(share(random)), 2.0 * M_PI * share(random));
    scan->emplace_back(p.x(), p.y(), p.z());
  }

  ScannedSurface<pcl::PointXYZ> scanned;
  scanned.setInputCloud(scan);
  Surface::ConstPtr surface;
  scanned.compute(surface);
  if (!surface)
    return 1; // the class has reported the error

  RadialLineSet set; // from the centre to the rim, counter-clockwise seen from outside
  for (int i = 0; i < 60; ++i) {
    RadialLine line;
    Polyline points;
    for (int k = 0; k <= 40; ++k) {
      points.push_back(at(reach * k / 40.0, 2.0 * M_PI * i / 60.0));
      line.feet.push_back(surface->fit().project(points.back()));
    }
    line.curve = fitBSpline(points)->curve;
    line.rim_share = line.turn_share = i / 60.0;
    set.lines.push_back(line);
    set.rim.push_back(points.back());
  }

  SpiralToolpathGenerator<pcl::PointXYZ> spiral;
  spiral.setInputSurface(surface);
  spiral.setRadialLines(set); // checked; a line that does not fit is refused, with its place
  spiral.setToolRadius(6.0);
  spiral.setScallopHeight(0.1);
  pcl::PointCloud<ToolpathPoint> path;
  spiral.compute(path);
  std::printf("%zu turns, %.2f m\n", spiral.getReport().turns, spiral.getReport().path_length / 1000.0);
  return path.empty() ? 1 : 0;
}
