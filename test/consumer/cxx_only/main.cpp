// SPDX-License-Identifier: BSD-3-Clause
// Reads a scan, makes its spiral toolpath, writes it.
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
  const pcl_spiral::Scan scan = pcl_spiral::readCloud(argv[1]);

  pcl_spiral::SpiralToolpathGenerator<pcl::PointXYZ> spiral;
  spiral.setInputCloud(scan.cloud);
  if (scan.normals)
    spiral.setInputNormals(scan.normals);
  if (scan.view_point)
    spiral.setViewPoint(*scan.view_point); // else the cutter comes from +z
  spiral.setToolRadius(10.0);              // mm
  spiral.setScallopHeight(0.05);           // mm
  spiral.setChordError(0.005);             // mm
  spiral.setProgressCallback([](double share, const std::string& stage) {
    std::cerr << static_cast<int>(100 * share) << " % " << stage << '\n';
    return true; // false cancels
  });
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
