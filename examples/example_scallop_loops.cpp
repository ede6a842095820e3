// SPDX-License-Identifier: BSD-3-Clause
// A bent plate with two holes: closed loops one step-over apart, then step by step one path over them.
#include <pcl_spiral/spiral/loop_linking.h>
#include <pcl_spiral/spiral/scallop_loops.h>
#include <pcl_spiral/spiral/spiral_path.h>

#include <cmath>
#include <cstdio>
#include <random>
using namespace pcl_spiral;
using Point = pcl::PointXYZ;
int
main()
{
  pcl::PointCloud<Point>::Ptr scan(new pcl::PointCloud<Point>); // 120 x 80 mm
  std::mt19937 random(1);
  std::uniform_real_distribution<float> side(-1.0f, 1.0f);
  while (scan->size() < 10000) {
    const float x = 60.0f * side(random), y = 40.0f * side(random);
    if (std::hypot(x + 28.0f, y - 5.0f) > 13.0f && std::hypot(x - 30.0f, y + 6.0f) > 11.0f)
      scan->emplace_back(x, y, -0.002f * x * x);
  }
  ScannedSurface<Point> scanned;
  scanned.setInputCloud(scan);
  Surface::ConstPtr surface;
  scanned.compute(surface);
  StepOverField<Point> distances; // from rim and holes, in step-overs of this ball and scallop height
  distances.setInputSurface(surface);
  distances.setToolRadius(5.0);    // mm
  distances.setScallopHeight(0.1); // mm
  StepOverDistance::ConstPtr field;
  distances.compute(field);
  if (!field)
    return 1; // the class has reported the error
  ScallopLoops<Point> closed;
  closed.setInputField(field);
  ScallopLoopSet set;
  closed.compute(set);
  SpiralSettings settings; // of the projection onto the surface
  settings.tool_radius = 5.0;
  settings.scallop_height = 0.1;
  DrivePasses passes; // the loops unchanged, a toolpath of closed passes
  putLoopsOnSurface(set.loops, *surface, settings, {}, passes);
  LoopLinking<Point> linking;
  linking.setInputField(field);
  linking.setInputLoops(set.loops);
  LinkedPath path; // the loops linked to one path
  linking.compute(path);
  std::printf("one path: %zu loops in a spiral, %zu beside it, %.0f mm; no path is shorter than %.0f mm\n", path.chain_loops, path.bridges,
              length(path.points), field->least_length);
  SpiralTurns turns; // points for linear moves
  samplePath(path, *surface, settings, turns);
  SpiralPath toolpath; // contacts and normals; next come setToolAxes and checkPath
  GapReport gaps;
  putOnSurface(turns, *surface, settings, {}, toolpath, gaps);
  std::printf("%zu closed passes, or one path of %zu points\n", passes.size(), toolpath.contacts.size());
  return toolpath.contacts.empty() ? 1 : 0;
}
