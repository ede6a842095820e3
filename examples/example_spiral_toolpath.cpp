// SPDX-License-Identifier: BSD-3-Clause
// Makes a spiral toolpath of a scan: example_spiral_toolpath SCAN.pcd PATH.csv TOOL_RADIUS SCALLOP_HEIGHT CHORD_ERROR
// Lengths in mm. The extension sets the format of the path: .csv, .pcd, .ply, .vtp.
#include <pcl_spiral/io/toolpath_writer.h>
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>

#include <pcl/io/pcd_io.h>

#include <cstdio>
#include <cstdlib>
#include <exception>

int
main(int argc, char** argv)
{
  if (argc != 6) {
    std::fprintf(stderr, "usage: %s SCAN.pcd PATH.csv TOOL_RADIUS SCALLOP_HEIGHT CHORD_ERROR\n", argv[0]);
    return 2;
  }
  const double tool_radius = std::atof(argv[3]);
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  if (pcl::io::loadPCDFile(argv[1], *cloud) < 0)
    return 1; // the class has reported the error

  pcl_spiral::SpiralToolpathGenerator<pcl::PointXYZ> spiral;
  spiral.setInputCloud(cloud);
  spiral.setToolRadius(tool_radius);
  spiral.setScallopHeight(std::atof(argv[4]));
  spiral.setChordError(std::atof(argv[5]));
  pcl::PointCloud<pcl_spiral::ToolpathPoint> path;
  spiral.compute(path);
  if (!spiral.getStatus().ok())
    return 1; // the class has reported the error

  const pcl_spiral::SpiralReport& report = spiral.getReport();
  for (const pcl_spiral::Diagnostic& warning : report.warnings)
    std::fprintf(stderr, "warning: %s\n", warning.text().c_str());
  std::printf("%zu turns, %zu points, %.1f mm\n", report.turns, path.size(), report.path_length);
  try {
    pcl_spiral::writeToolpath(argv[2], path, {tool_radius, spiral.getSettings().feed});
  }
  catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
