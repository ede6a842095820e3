// SPDX-License-Identifier: BSD-3-Clause
// A spiral over one part of a scan, beside a clamp, with its holder checked, as
//   pcl_spiral_toolpath SCAN --tool-radius 4 --scallop 0.05 --keep-out CLAMP --part-at X,Y,Z --flank-length 30 --holder 6,40/20,25,60
// makes it: the same bytes.
#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/io/polygon_reader.h>
#include <pcl_spiral/io/toolpath_writer.h>
#include <pcl_spiral/planning/spiral_planner.h>

#include <iostream>

int
main(int argc, char** argv)
try {
  if (argc != 7) {
    std::cerr << "usage: " << argv[0] << " SCAN CLAMP X Y Z OUTPUT\n";
    return 2;
  }
  const pcl_spiral::Scan scan = pcl_spiral::readCloud(argv[1]);

  pcl_spiral::SpiralPlanner<pcl::PointXYZ> planner;
  planner.setInputCloud(scan.cloud); // all of it: what is not the part is an obstacle
  planner.setInputNormals(scan.normals);
  planner.setTrustNormals(false); // a scanner's normals without a common side are not used, with a warning
  if (scan.view_point)
    planner.setViewPoint(*scan.view_point);
  planner.addKeepOut(pcl_spiral::readPolygon(argv[2]));
  planner.setPartAt({std::stod(argv[3]), std::stod(argv[4]), std::stod(argv[5])});
  planner.setToolRadius(4.0);     // mm
  planner.setScallopHeight(0.05); // mm
  planner.setFlankLength(30.0);   // mm, from the centre of the ball to the holder
  planner.setHolder({pcl_spiral::ToolSegment::cylinder(6.0, 40.0, "shank"), {20.0, 25.0, 60.0, "chuck"}});
  pcl::PointCloud<pcl_spiral::ToolpathPoint> path;
  planner.compute(path);
  if (!planner.getStatus().ok()) {
    std::cerr << planner.getStatus().message() << '\n';
    return 1;
  }
  for (const pcl_spiral::Diagnostic& warning : planner.getWarnings())
    std::cerr << warning << '\n';
  pcl_spiral::writeToolpath(argv[6], path, {planner.getToolRadius(), planner.getFeed()});
  std::cout << path.size() << " points, " << planner.getPlan().attempts.size() << " tries, " << planner.getPlan().part.beside.size()
            << " points beside the part\n";
  return 0;
}
catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
