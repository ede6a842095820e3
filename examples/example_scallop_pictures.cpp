// SPDX-License-Identifier: BSD-3-Clause
// Makes the pictures of pcl_spiral/doc/constant_scallop.md: a part with three holes, its step-overs, closed loops, the tree that
// links them and the path, as PNG files in the current folder. It needs a display: xvfb-run -a example_scallop_pictures
#include <pcl_spiral/visualization/add_scallop_loops.h>
#include <pcl_spiral/visualization/pictures.h>

#include <cmath>
#include <cstdio>
#include <random>

using namespace pcl_spiral;
using Point = pcl::PointXYZ;

/** Saves the viewer as a picture, then empties it. */
static void
write(pcl::visualization::PCLVisualizer& viewer, const char* file)
{
  viewer.setCameraPosition(0, -40, 262, 0, 0, 0, 0, 1, 0);
  viewer.spinOnce();
  viewer.saveScreenshot(file);
  viewer.removeAllPointClouds();
  viewer.removeAllShapes();
}

int
main()
{
  if (const std::string fault = displayFault(); !fault.empty()) {
    std::fprintf(stderr, "pictures need a display and %s; run this under 'xvfb-run -a'\n", fault.c_str());
    return 1; // without a display PCLVisualizer would end the program
  }
  pcl::PointCloud<Point>::Ptr scan(new pcl::PointCloud<Point>);
  std::mt19937 random(1);
  std::uniform_real_distribution<float> side(-66.0f, 66.0f);
  while (scan->size() < 14000) {
    const float x = side(random), y = side(random);
    if (std::hypot(x, y) < 66.0f && std::hypot(x + 27.0f, y - 6.0f) > 11.0f && std::hypot(x - 30.0f, y + 9.0f) > 9.0f &&
        std::hypot((x - 3.0f) / 15.0f, (y - 36.0f) / 7.0f) > 1.0f)
      scan->emplace_back(x, y, 4.0f * std::sin(x / 27.0f) * std::cos(y / 30.0f));
  }
  LoopLinking<Point> linking; // makes field and loops as in the stages before it
  StepOverField<Point> distances;
  ScallopLoops<Point> closed;
  distances.setInputCloud(scan);
  distances.setToolRadius(5.0);
  distances.setScallopHeight(0.1);
  StepOverDistance::ConstPtr field;
  distances.compute(field);
  ScallopLoopSet set;
  closed.setInputField(field);
  closed.compute(set);
  linking.setInputField(field);
  linking.setInputLoops(set.loops);
  LinkedPath path;
  linking.compute(path);
  if (path.points.empty())
    return 1; // the class has reported the error

  pcl::visualization::PCLVisualizer viewer("constant scallop");
  viewer.setSize(720, 640);
  viewer.setBackgroundColor(1.0, 1.0, 1.0);
  viewer.setShowFPS(false);
  addStepOverField(viewer, *field);
  write(viewer, "scallop_field.png");
  addScallopLoops(viewer, set);
  write(viewer, "scallop_loops.png");
  addLoopTree(viewer, set.loops, path);
  write(viewer, "scallop_tree.png");
  addLinkedPath(viewer, path, set.loops);
  write(viewer, "scallop_path.png");
  return 0;
}
