// SPDX-License-Identifier: BSD-3-Clause
// A dome with a hole and two gaps in its scan: the hole stays, the gaps are bridged by points that are marked as estimated.
#include <pcl_spiral/features/boundary_loops.h>
#include <pcl_spiral/spiral/gap_bridging.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

int
main()
{
  const double radius = 200.0, rim = 60.0; // of the sphere, and of the dome's rim, mm
  pcl::PointCloud<pcl::PointXYZ>::Ptr scan(new pcl::PointCloud<pcl::PointXYZ>);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-rim, rim);
  while (scan->size() < 20000) {
    const double x = place(random), y = place(random);
    if (std::hypot(x, y) < rim && std::hypot(x, y) > 15.0 && std::hypot(x - 35.0, y) > 4.0 && std::hypot(x, y + 40.0) > 5.0)
      scan->emplace_back(x, y, std::sqrt(radius * radius - x * x - y * y));
  }

  pcl_spiral::GapBridging<pcl::PointXYZ> bridging; // if you have a surface and loops: setInputSurface, setBoundaryLoops
  bridging.setInputCloud(scan);
  pcl_spiral::Surface::ConstPtr surface;
  std::vector<pcl_spiral::BoundaryLoop> loops;
  bridging.compute(surface, loops);
  if (!surface)
    return 1; // the class has reported the error; bridging.getStatus() has it too

  for (const pcl_spiral::BridgedGap& gap : bridging.getGaps())
    std::printf("gap at (%.1f, %.1f, %.1f), %.1f mm wide: %zu points; those about it lie %.5f mm from the patch\n", gap.centre.x(),
                gap.centre.y(), gap.centre.z(), gap.width, gap.points, gap.residual);
  for (const pcl_spiral::BoundaryLoop& loop : loops)
    std::printf("%s loop of %.1f mm\n", loop.type == pcl_spiral::LoopType::Outer ? "outer" : "inner", loop.length);

  double error = 0.0;
  for (std::size_t i = 0; i < surface->size(); ++i)
    if (surface->isGuessed(i))
      error = std::max(error, std::abs(surface->position(i).norm() - radius));
  std::printf("%zu of %zu points are guesses, at most %.5f mm off the sphere\n", surface->report().guessed, surface->size(), error);

  bridging.setGapHandling(pcl_spiral::GapHandling::Refuse);
  bridging.setQuiet(true);
  bridging.compute(surface, loops);
  std::printf("told to refuse: %s\n", bridging.getStatus().message().c_str());
  return 0;
}
