// SPDX-License-Identifier: BSD-3-Clause
// Step-over of a ball cutter on convex, flat and concave surfaces: exact, first order and as published.
#include <pcl_spiral/core/step_over.h>

#include <cstdio>
#include <cstdlib>

int
main(int argc, char** argv)
{
  const double radius = argc > 1 ? std::atof(argv[1]) : 10.0;
  const double height = argc > 2 ? std::atof(argv[2]) : 0.05;
  const auto published = pcl_spiral::stepOverPublished(radius, height);
  if (!published) {
    std::fprintf(stderr, "usage: example_step_over [RADIUS SCALLOP], mm, 0 < SCALLOP < RADIUS\n");
    return 2;
  }
  std::printf("ball radius %g mm, scallop height %g mm, published step-over %.5f mm\n", radius, height, *published);
  std::printf("%12s %12s %12s %22s\n", "rho (mm)", "exact", "first order", "scallop of published");
  for (double curvature : {0.1, 0.02, 0.001, 0.0, -0.001, -0.02, -0.05, -0.2}) {
    const auto exact = pcl_spiral::stepOver(radius, curvature, height);
    if (!exact) {
      std::printf("%12.1f  the ball does not fit: its radius must be below %g mm here\n", 1 / curvature, -1 / curvature);
      continue;
    }
    const auto first = pcl_spiral::stepOverFirstOrder(radius, curvature, height);
    const auto left = pcl_spiral::scallopHeight(radius, curvature, *published);
    std::printf("%12.1f %12.5f %12.5f %22.5f\n", 1 / curvature, *exact, *first, left ? *left : 0.0);
  }
  return 0;
}
