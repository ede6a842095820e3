// SPDX-License-Identifier: BSD-3-Clause
// A spiral over a scan from one side, closed by the ball, as
//   pcl_spiral_toolpath SCAN --tool-radius 5 --scallop 0.05 --axis 0,0,1 --ball-closing
// makes it: the same bytes. Also writes the closed scan, to look at.
#include <pcl_spiral/cleaning/ball_closing.h>
#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/io/toolpath_writer.h>
#include <pcl_spiral/planning/spiral_planner.h>

#include <pcl/io/pcd_io.h>

#include <iostream>

int
main(int argc, char** argv)
try {
  if (argc != 4) {
    std::cerr << "usage: " << argv[0] << " SCAN OUTPUT CLOSED.pcd\n";
    return 2;
  }
  const pcl_spiral::Scan scan = pcl_spiral::readCloud(argv[1]);

  pcl_spiral::BallClosing<pcl::PointXYZ> closing;
  closing.setInputCloud(scan.cloud);
  closing.setDirection({0, 0, 1}); // from where the tool comes
  closing.setToolRadius(5.0);      // mm
  pcl::PointCloud<pcl::PointXYZ> closed;
  closing.compute(closed);
  if (!closing.getStatus().ok())
    return 1;
  pcl::io::savePCDFileBinary(argv[3], closed);
  std::cout << closing.getReport().covered << " of " << closing.getReport().points << " points are out of reach of the ball\n";

  pcl_spiral::SpiralPlanner<pcl::PointXYZ> planner; // closes the scan itself
  planner.setInputCloud(scan.cloud);
  planner.setFixedAxis({0, 0, 1});
  planner.setToolRadius(5.0);
  planner.setScallopHeight(0.05); // mm
  planner.setBallClosing(true);
  pcl::PointCloud<pcl_spiral::ToolpathPoint> path;
  planner.compute(path);
  if (!planner.getStatus().ok())
    return 1;
  for (const pcl_spiral::Diagnostic& warning : planner.getWarnings())
    std::cerr << warning << '\n';
  pcl_spiral::writeToolpath(argv[2], path, {planner.getToolRadius(), planner.getFeed()});
  return 0;
}
catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
