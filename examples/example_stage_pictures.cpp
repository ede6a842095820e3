// SPDX-License-Identifier: BSD-3-Clause
// Makes the pictures of pcl_spiral/doc/stage_by_stage.md: the result of each stage of example_stage_by_stage, as PNG files in
// the current folder. It needs a display: xvfb-run -a example_stage_pictures
#include <pcl_spiral/spiral/gap_bridging.h>
#include <pcl_spiral/spiral/radial_lines.h>
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>
#include <pcl_spiral/visualization/add_toolpath.h>
#include <pcl_spiral/visualization/pictures.h>

#include <cmath>
#include <cstdio>
#include <random>

using namespace pcl_spiral;
using Dots = pcl::PointCloud<pcl::PointXYZRGBNormal>;
using Path = pcl::PointCloud<ToolpathPoint>;

constexpr pcl::RGB gray(140, 150, 165), blue(40, 90, 190), red(215, 25, 25), magenta(190, 40, 180);

static pcl::PointXYZRGBNormal
dot(const Eigen::Vector3f& p, const Eigen::Vector3f& n, const pcl::RGB& color)
{
  return {p.x(), p.y(), p.z(), color.r, color.g, color.b, n.x(), n.y(), n.z()};
}

static Dots::Ptr
dotsOf(const Surface& surface)
{
  const Dots::Ptr dots(new Dots);
  for (std::size_t i = 0; i < surface.size(); ++i)
    dots->push_back(dot(surface.position(i).cast<float>(), surface.normal(i).cast<float>(), surface.isGuessed(i) ? magenta : blue));
  return dots;
}

/** Saves a picture of points and every fourth of their normals, of the whole dome or the gap; then empties the viewer. */
static void
write(pcl::visualization::PCLVisualizer& viewer, const char* file, bool whole, const Dots::Ptr& dots, double size)
{
  viewer.addPointCloud<pcl::PointXYZRGBNormal>(dots, "dots");
  viewer.setPointCloudRenderingProperties(pcl::visualization::PCL_VISUALIZER_POINT_SIZE, size, "dots");
  if (!dots->empty() && viewer.addPointCloudNormals<pcl::PointXYZRGBNormal>(dots, 4, 3.0f, "normals"))
    viewer.setPointCloudRenderingProperties(pcl::visualization::PCL_VISUALIZER_COLOR, 0.5, 0.5, 0.6, "normals");
  if (whole)
    viewer.setCameraPosition(0, -85, 310, 0, -8, 88, 0, 1, 0);
  else
    viewer.setCameraPosition(25, -22, 139, 25, 0, 95, 0, 1, 0);
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
  pcl::PointCloud<pcl::PointXYZ>::Ptr scan(new pcl::PointCloud<pcl::PointXYZ>); // the dome of example_stage_by_stage
  std::mt19937 random(1);
  std::uniform_real_distribution<float> side(-60.0f, 60.0f);
  while (scan->size() < 8000) {
    const float x = side(random), y = side(random), echo = scan->size() % 200 == 0 ? 6.0f : 0.0f;
    if (std::hypot(x, y) < 60.0f && std::hypot(x - 25.0f, y) > 7.0f)
      scan->emplace_back(x, y, std::sqrt(100.0f * 100.0f - x * x - y * y) + echo);
  }
  pcl::visualization::PCLVisualizer viewer("stages");
  viewer.setSize(800, 640);
  viewer.setBackgroundColor(1.0, 1.0, 1.0);
  viewer.setShowFPS(false);

  ScannedSurface<pcl::PointXYZ> scanned;
  scanned.setInputCloud(scan);
  Surface::ConstPtr surface;
  scanned.compute(surface);
  const Dots::Ptr dots(new Dots), none(new Dots), axes(new Dots);
  for (const pcl::PointXYZ& point : *scan)
    dots->push_back(dot(point.getVector3fMap(), {0, 0, 0}, gray));
  for (const Eigen::Vector3f& place : surface->leftOut().positions)
    dots->push_back(dot(place, {0, 0, 0}, red));
  write(viewer, "stage_scan.png", true, dots, 4.0);
  write(viewer, "stage_surface.png", false, dotsOf(*surface), 5.0);

  GapBridging<pcl::PointXYZ> bridging;
  bridging.setInputSurface(surface);
  std::vector<BoundaryLoop> loops;
  bridging.compute(surface, loops);
  write(viewer, "stage_bridged.png", false, dotsOf(*surface), 5.0);

  SpiralToolpathGenerator<pcl::PointXYZ> spiral; // its report has loops and lines
  spiral.setInputCloud(scan);
  spiral.setToolRadius(6.0);
  spiral.setScallopHeight(0.1);
  spiral.setMethod(SpiralMethod::Radial);
  Path path;
  spiral.compute(path);
  addToolpath(viewer, Path(), spiral.getReport().loops);
  write(viewer, "stage_loops.png", true, dots, 2.0);
  addToolpath(viewer, Path(), spiral.getReport().loops, spiral.getReport().radial_lines);
  write(viewer, "stage_lines.png", true, none, 1.0);
  addToolpath(viewer, path);
  write(viewer, "stage_path.png", true, none, 1.0);

  for (const ToolpathPoint& point : path)
    axes->push_back(dot(point.getVector3fMap(), point.getAxisVector3fMap(), gray));
  addToolpath(viewer, path);
  write(viewer, "stage_axes.png", false, axes, 1.0);
  return path.empty() ? 1 : 0;
}
