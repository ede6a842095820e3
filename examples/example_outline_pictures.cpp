// SPDX-License-Identifier: BSD-3-Clause
// The figure of README's "Short on any outline", outlines.png in the current folder: xvfb-run -a example_outline_pictures
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>
#include <pcl_spiral/visualization/add_toolpath.h>
#include <pcl_spiral/visualization/pictures.h>

#include <cmath>
#include <cstdio>
#include <random>

using namespace pcl_spiral;

static bool
isInside(int part, float x, float y)
{
  const bool square = std::abs(x) < 60.0f && std::abs(y) < 60.0f;
  return part == 0   ? std::abs(x - y) < 112.0f && std::abs(x + y) < 14.0f // 8:1, drawn across
         : part == 1 ? square && (x < -18.0f || y < -18.0f)
         : part == 2 ? square && (std::abs(x) > 20.0f || y < -20.0f)
                     : std::hypot(x, y) < 60.0f && std::hypot(x + 25.0f, y) > 11.0f && std::hypot(x - 25.0f, y + 8.0f) > 10.0f &&
                           std::hypot(x - 4.0f, y - 34.0f) > 12.0f;
}

int
main()
{
  if (const std::string fault = displayFault(); !fault.empty()) // without a display PCLVisualizer would end the program
    return std::fprintf(stderr, "pictures need a display and %s; run this under 'xvfb-run -a'\n", fault.c_str());
  pcl::visualization::PCLVisualizer viewer("outlines");
  viewer.setSize(1200, 640);
  std::mt19937 random(1);
  std::uniform_real_distribution<float> side(-65.0f, 65.0f);
  pcl::PointCloud<pcl::PointXYZ>::Ptr scan(new pcl::PointCloud<pcl::PointXYZ>);
  SpiralReport scallop; // holds the least length
  for (int view = 0; view < 8; ++view) {
    const int part = view / 2, row = view % 2; // row 0 below, row 1 above
    if (row == 0)
      scan->clear();
    while (scan->size() < 9000)
      if (const float x = side(random), y = side(random); isInside(part, x, y))
        scan->emplace_back(x, y, 0.0f);
    SpiralToolpathGenerator<pcl::PointXYZ> spiral;
    spiral.setInputCloud(scan);
    spiral.setToolRadius(10.0);
    spiral.setScallopHeight(part == 0 ? 0.05 : 0.1); // the strip is narrow
    spiral.setMethod(row == 0 ? SpiralMethod::ConstantScallop : SpiralMethod::Radial);
    pcl::PointCloud<ToolpathPoint> path;
    spiral.compute(path);
    scallop = row == 0 ? spiral.getReport() : scallop;
    const std::string share = path.empty() ? "refused" : std::to_string(path.back().arc_length / scallop.least_length);
    const std::string words = (row == 0 ? "constant scallop: " : "radial: ") + share.substr(0, path.empty() ? 7 : 4);
    int port = 0;
    viewer.createViewPort(0.25 * part, 0.5 * row, 0.25 * part + 0.25, 0.5 * row + 0.5, port);
    viewer.setBackgroundColor(1.0, 1.0, 1.0, port);
    viewer.createViewPortCamera(port);
    viewer.setCameraPosition(0, -9, 275, 0, -9, 0, 0, 1, 0, port);
    addToolpath(viewer, path, scallop.loops, std::vector<Polyline>(), "path" + std::to_string(view), port);
    viewer.addText(words, 8, 8, 18, 0, 0, 0, "text" + std::to_string(view), port);
  }
  viewer.spinOnce();
  viewer.saveScreenshot("outlines.png");
}
