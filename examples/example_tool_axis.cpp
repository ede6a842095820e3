// SPDX-License-Identifier: BSD-3-Clause
// Tool axes along a flat spiral: tilted 15 degrees about the feed, with a limit in degrees per mm near the
// centre.
#include <pcl_spiral/spiral/tool_axis.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

int
main(int argc, char** argv)
{
  pcl::PointCloud<pcl_spiral::ToolpathPoint>::Ptr path(new pcl::PointCloud<pcl_spiral::ToolpathPoint>);
  for (double angle = 0.0; angle < 40.0; angle += 0.5 / (1.0 + 0.3 * angle)) {
    pcl_spiral::ToolpathPoint p;
    p.x = static_cast<float>(0.3 * angle * std::cos(angle));
    p.y = static_cast<float>(0.3 * angle * std::sin(angle));
    p.normal_z = 1.0f;
    p.turn = static_cast<float>(angle / (2.0 * M_PI));
    path->push_back(p);
  }

  pcl_spiral::ToolAxis tool_axis;
  tool_axis.setInputPath(path);
  tool_axis.setTiltAngle(15.0);                                  // degrees
  tool_axis.setMaxAxisRate(argc > 1 ? std::atof(argv[1]) : 5.0); // degrees per mm
  pcl::PointCloud<pcl_spiral::ToolpathPoint> out;
  tool_axis.compute(out);
  if (!tool_axis.getStatus().ok())
    return 1;

  for (std::size_t i = 0; i < out.size(); i += 8)
    std::printf("turn %5.2f  axis %7.4f %7.4f %7.4f  tilt %6.2f degrees\n", out[i].turn, out[i].axis_x, out[i].axis_y, out[i].axis_z,
                std::acos(std::min(1.0f, out[i].axis_z)) * 180.0 / M_PI);
  const pcl_spiral::AxisField& field = tool_axis.getField();
  std::printf("%zu of %zu points over %g degrees off the tilt; largest change %.3f degrees, rate %.3f a mm\n", field.getDeviatingPoints(),
              out.size(), field.getAxisDeviation(), field.getLargestAxisChange(), field.getLargestAxisRate());
  return 0;
}
