// SPDX-License-Identifier: BSD-3-Clause
// PCL's smoothing before the first stage, or MLSProjector instead: both are pcl::CloudSurfaceProcessing.
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>
#include <pcl_spiral/surface/mls_projector.h>

#include <pcl/surface/mls.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

using Point = pcl::PointXYZ;

int
main()
{
  const double radius = 150.0, rim = 60.0; // of a sphere, and of a dome on it, mm
  pcl::PointCloud<Point>::Ptr scan(new pcl::PointCloud<Point>), smooth(new pcl::PointCloud<Point>);
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0.0, 0.02);
  std::uniform_real_distribution<double> place(-rim, rim);
  while (scan->size() < 8000)
    if (const double x = place(random), y = place(random); std::hypot(x, y) < rim)
      scan->emplace_back(x, y, std::sqrt(radius * radius - x * x - y * y) + noise(random));

  pcl::MovingLeastSquares<Point, Point> theirs;
  theirs.setSearchRadius(8.0); // mm
  theirs.setPolynomialOrder(2);
  pcl_spiral::MLSProjector<Point, Point> ours; // as wide as the noise needs

  using Stage = pcl::CloudSurfaceProcessing<Point, Point>;
  for (Stage* stage : {static_cast<Stage*>(&theirs), static_cast<Stage*>(&ours)}) {
    stage->setInputCloud(scan);
    stage->process(*smooth);

    pcl_spiral::SpiralToolpathGenerator<Point> spiral;
    spiral.setInputCloud(smooth);
    spiral.setToolRadius(6.0);
    spiral.setScallopHeight(0.1);
    pcl::PointCloud<pcl_spiral::ToolpathPoint> path;
    spiral.compute(path);
    double error = 0.0;
    for (const pcl_spiral::ToolpathPoint& point : path)
      error = std::max(error, std::abs(point.getVector3fMap().cast<double>().norm() - radius));
    std::printf("%s: %zu turns, at most %.4f mm off the sphere\n", stage == &theirs ? "PCL's" : "ours", spiral.getReport().turns, error);
    if (path.empty())
      return 1; // the class has reported the error
  }
  return 0;
}
