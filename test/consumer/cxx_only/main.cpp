// Uses the installed headers and library from outside.
#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/core/step_over.h>

#include <pcl/point_cloud.h>

#include <cmath>
#include <iostream>

int
main()
{
  const auto step = pcl_spiral::stepOver(10.0, 1.0 / 50.0, 0.05);
  pcl::PointCloud<pcl_spiral::ToolpathPoint> path(1, 1);
  path[0].arc_length = 1e7 + 1e-3;
  const bool right = step && std::abs(*step - 1.82257) < 1e-5 && path[0].arc_length - 1e7 > 9e-4;
  std::cout << "cxx_only: step-over " << step.value_or(0) << " mm\n";
  return right ? 0 : 1;
}
