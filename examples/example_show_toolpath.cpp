// SPDX-License-Identifier: BSD-3-Clause
// Shows the toolpath of a dome in a PCLVisualizer, with its scan, loops and radial lines.
// example_show_toolpath [SECONDS]: the mouse turns it; it ends with q or after the given seconds.
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>
#include <pcl_spiral/visualization/add_toolpath.h>
#include <pcl_spiral/visualization/pictures.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>

int
main(int argc, char** argv)
{
  const double seconds = argc > 1 ? std::atof(argv[1]) : std::numeric_limits<double>::infinity();
  if (const std::string fault = pcl_spiral::displayFault(); !fault.empty()) {
    std::fprintf(stderr, "a viewer needs a display and %s; run it under 'xvfb-run -a'\n", fault.c_str());
    return 1; // without a display PCLVisualizer would end the program
  }

  const double radius = 120.0, rim = 80.0; // of the sphere, and of the dome's rim, mm
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-rim, rim);
  while (cloud->size() < 20000) {
    const double x = place(random), y = place(random), z = std::sqrt(radius * radius - x * x - y * y);
    if (std::hypot(x, y) < rim && std::hypot(x - 25.0, y - 30.0) > 6.0) // a shadow in the scan
      cloud->emplace_back(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
  }

  pcl_spiral::SpiralToolpathGenerator<pcl::PointXYZ> spiral;
  spiral.setInputCloud(cloud);
  spiral.setToolRadius(10.0);
  spiral.setScallopHeight(0.2);
  pcl::PointCloud<pcl_spiral::ToolpathPoint> path;
  spiral.compute(path);
  if (!spiral.getStatus().ok())
    return 1; // the class has reported the error

  pcl::visualization::PCLVisualizer viewer("A toolpath on its scan");
  viewer.addPointCloud(cloud, "scan");
  pcl_spiral::addToolpath(viewer, path, spiral.getReport().loops, spiral.getReport().radial_lines);
  viewer.setCameraPosition(0.0, -250.0, 350.0, 0.0, 0.0, 100.0, 0.0, 1.0, 0.0);

  const auto start = std::chrono::steady_clock::now();
  while (!viewer.wasStopped() && std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() < seconds)
    viewer.spinOnce(50);
  return 0;
}
