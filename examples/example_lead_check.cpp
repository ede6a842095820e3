// SPDX-License-Identifier: BSD-3-Clause
// A dome with a screw and false echoes: checks the leads of its spiral against the scan, with the echoes and without them.
#include <pcl_spiral/machine/machine_program_generator.h>
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>
#include <pcl_spiral/verify/lead_check.h>

#include <cmath>
#include <cstdio>
#include <random>

using namespace pcl_spiral;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;

int
main()
{
  std::mt19937 random(1);
  std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
  const Cloud::Ptr scan(new Cloud);
  for (int i = 0; i < 20000; ++i) {
    const float x = 40.0f * unit(random), y = 40.0f * unit(random);
    scan->push_back({x, y, std::sqrt(120.0f * 120.0f - x * x - y * y)});
  }
  for (int i = 0; i < 150; ++i) // echoes in the air
    scan->push_back({40.0f * unit(random), 40.0f * unit(random), 150.0f + 20.0f * unit(random)});
  for (int i = 0; i < 12; ++i) // a screw above the middle
    scan->push_back({2.0f * unit(random), 2.0f * unit(random), 128.0f + 0.5f * unit(random)});

  SpiralToolpathGenerator<pcl::PointXYZ> spiral; // leaves both out
  spiral.setInputCloud(scan);
  spiral.setToolRadius(5.0);
  spiral.setScallopHeight(0.1);
  pcl::PointCloud<ToolpathPoint> path;
  spiral.compute(path);
  MachineProgramGenerator generator;
  generator.setMachine(xyzacTrunnion());
  generator.setInputPath(path, 5.0);
  MachineProgram program;
  generator.compute(program);
  if (!generator.getStatus().ok())
    return 1;

  LeadCheck<pcl::PointXYZ> check;
  check.setCutter(CutterShape::ball(5.0));
  check.setLargestEcho(3); // larger groups of outliers are not echoes
  check.setInputCloud(scan);
  check.compute(program);
  const auto print = [](const char* name, const LeadReport& f) {
    std::printf("%s: %zu of %zu moves off the path touch, by %.2f mm at most\n", name, f.collided, f.moves, f.deepest.depth);
  };
  print("all points", check.getReport());
  print("without echoes", check.getObstacleReport());
  return check.getStatus().ok() ? 0 : 1;
}
