// Uses the installed headers and libraries from outside. Writes and removes FOLDER/path.csv.
#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/io/toolpath_reader.h>
#include <pcl_spiral/io/toolpath_writer.h>

#include <cmath>
#include <cstdio>
#include <iostream>

int
main(int argc, char** argv)
{
  if (argc != 2) {
    std::cerr << "usage: cxx_only FOLDER\n";
    return 2;
  }
  const double side = 100.0;
  const pcl_spiral::Polyline square{{0, 0, 0}, {side, 0, 0}, {side, side, 0}, {0, side, 0}};
  const std::vector<double> arc = pcl_spiral::arcLengths(square);
  pcl::PointCloud<pcl_spiral::ToolpathPoint> path;
  for (std::size_t i = 0; i < square.size(); ++i) {
    pcl_spiral::ToolpathPoint point;
    point.getVector3fMap() = square[i].cast<float>();
    point.normal_z = point.axis_z = 1.0f;
    point.arc_length = arc[i];
    path.push_back(point);
  }
  const std::string file = std::string(argv[1]) + "/path.csv";
  pcl_spiral::writeToolpath(file, path, {10.0, 1000.0});
  const auto read = pcl_spiral::readToolpath(file).path;
  std::remove(file.c_str());
  const bool same = read.size() == 4 && read.back().y == 100.0f && std::abs(read.back().arc_length - 300.0) < 1e-6;
  std::cout << "cxx_only: outline " << pcl_spiral::length(square, true) << " mm, " << read.size()
            << " points written and read\n";
  return same ? 0 : 1;
}
