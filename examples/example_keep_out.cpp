// SPDX-License-Identifier: BSD-3-Clause
// A spiral round a clamp: what is not cut of a scan is an obstacle, and the ball keeps out of a polygon.
#include <pcl_spiral/cleaning/part_region.h>
#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/io/toolpath_writer.h>
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>

#include <iostream>

int
main(int argc, char** argv)
try {
  if (argc != 3) {
    std::cerr << "usage: " << argv[0] << " SCAN OUTPUT\n";
    return 2;
  }
  const pcl::PointCloud<pcl::PointXYZ>::ConstPtr scan = pcl_spiral::readCloud(argv[1]).cloud;

  pcl_spiral::PartRegion<pcl::PointXYZ> region; // a square of 10 mm about the origin, over and under it without end
  region.setInputCloud(scan);
  region.addKeepOut(pcl_spiral::Prism({{-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0}}, Eigen::Vector3d::UnitZ()));
  region.setToolRadius(6.0); // mm
  region.setMargin(1.0);     // mm
  const pcl::IndicesPtr part(new pcl::Indices);
  region.filter(*part); // pcl::Indices

  pcl_spiral::SpiralToolpathGenerator<pcl::PointXYZ> spiral;
  spiral.setInputCloud(scan);
  spiral.setIndices(part);
  pcl_spiral::Surroundings around;
  around.keep_outs = region.getKeepOuts();
  spiral.setSurroundings(around);
  spiral.setToolRadius(6.0);
  spiral.setScallopHeight(0.05);
  pcl::PointCloud<pcl_spiral::ToolpathPoint> path;
  spiral.compute(path);
  if (!spiral.getStatus().ok()) {
    std::cerr << spiral.getStatus().message() << '\n';
    return 1;
  }
  pcl_spiral::writeToolpath(argv[2], path, {spiral.getToolRadius(), 1000.0}); // feed in mm/min
  std::cout << path.size() << " points, " << path.back().arc_length / 1000 << " m\n";
  return 0;
}
catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
