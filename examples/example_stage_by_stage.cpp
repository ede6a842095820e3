// SPDX-License-Identifier: BSD-3-Clause
// A spiral toolpath stage by stage: each stage takes the result of the stage before, and you can replace each.
#include <pcl_spiral/features/boundary_loops.h>
#include <pcl_spiral/spiral/gap_bridging.h>
#include <pcl_spiral/spiral/radial_lines.h>
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>

#include <cmath>
#include <cstdio>
#include <random>

using Point = pcl::PointXYZ;

int
main()
{
  pcl::PointCloud<Point>::Ptr scan(new pcl::PointCloud<Point>); // a dome of 120 mm, with outliers and a gap in the data
  std::mt19937 random(1);
  std::uniform_real_distribution<float> side(-60.0f, 60.0f);
  while (scan->size() < 8000) {
    const float x = side(random), y = side(random), echo = scan->size() % 200 == 0 ? 6.0f : 0.0f;
    if (std::hypot(x, y) < 60.0f && std::hypot(x - 25.0f, y) > 7.0f)
      scan->emplace_back(x, y, std::sqrt(100.0f * 100.0f - x * x - y * y) + echo);
  }

  pcl_spiral::ScannedSurface<Point> scanned; // clean, oriented, triangulated: made once, shared by all stages
  scanned.setInputCloud(scan);
  pcl_spiral::Surface::ConstPtr surface;
  scanned.compute(surface);
  if (!surface)
    return 1; // scanned.getStatus() has the error, as in every stage

  pcl_spiral::BoundaryLoops<Point> boundaries; // its rim and holes
  boundaries.setInputSurface(surface);
  std::vector<pcl_spiral::BoundaryLoop> loops;
  boundaries.compute(loops);
  std::printf("%zu points of %zu, %zu loops\n", surface->size(), surface->inputSize(), loops.size());

  pcl_spiral::GapBridging<Point> bridging; // a new surface, with patches over the gaps
  bridging.setInputSurface(surface);
  bridging.setBoundaryLoops(loops);
  bridging.compute(surface, loops);
  for (const pcl_spiral::BridgedGap& gap : bridging.getGaps())
    std::printf("gap %.1f mm wide, bridged by %zu points\n", gap.width, gap.points);

  pcl_spiral::RadialLines<Point> radial; // the frame the spiral is drawn on
  radial.setInputSurface(surface);
  radial.setBoundaryLoops(loops);
  pcl_spiral::RadialLineSet lines;
  radial.compute(lines);
  std::printf("%zu radial lines\n", lines.lines.size());

  pcl_spiral::SpiralToolpathGenerator<Point> spiral; // turns, projection, tool axis
  spiral.setInputSurface(surface);
  spiral.setBoundaryLoops(loops);
  spiral.setRadialLines(lines);
  spiral.setToolRadius(6.0);    // mm
  spiral.setScallopHeight(0.1); // mm
  pcl::PointCloud<pcl_spiral::ToolpathPoint> path;
  spiral.compute(path);
  std::printf("%zu turns, %.2f m\n", spiral.getReport().turns, spiral.getReport().path_length / 1000.0);
  return path.empty() ? 1 : 0;
}
