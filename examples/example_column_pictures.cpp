// SPDX-License-Identifier: BSD-3-Clause
// Makes column_passes.png of pcl_spiral/doc/drive.md in the current folder: the column of pcl_spiral_simulate_scan cut by a helix, and
// by planes along two tool axes, red where more than 0.1 mm is left. xvfb-run -a example_column_pictures column.pcd
#include <pcl_spiral/cutter/cutter_location.h>
#include <pcl_spiral/drive/drive_path.h>
#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/visualization/add_toolpath.h>
#include <pcl_spiral/visualization/pictures.h>

#include <pcl/kdtree/kdtree_flann.h>

#include <cmath>
#include <cstdio>
using namespace pcl_spiral;
using Viewer = pcl::visualization::PCLVisualizer;

constexpr double ball = 4.0, step_over = 1.0;

/** Passes of the ball, with locations added until its moves keep the tolerance. */
static std::vector<ToolLocations>
located(const Scan& scan, DriveKind kind, const Eigen::Vector3d& axis)
{
  DrivePath<pcl::PointXYZ> drive;
  drive.setInputCloud(scan.cloud);
  drive.setKind(kind);
  drive.setAxis(axis);
  drive.setStepOver(step_over);
  drive.setPointSpacing(0.5);
  drive.setOverrun(kind == DriveKind::Helix ? 2.0 : 0.0); // the waist leans at the ends
  DrivePasses passes;
  drive.compute(passes);
  CutterLocation<pcl::PointXYZ> location;
  location.setInputCloud(scan.cloud);
  location.setCutter(CutterShape::ball(ball));
  location.setDrivePasses(passes);
  location.setPathTolerance(0.01);
  std::vector<ToolLocations> found;
  location.compute(found);
  return found;
}

/** Tips along the passes, coloured by height. */
static pcl::PointCloud<ToolpathPoint>
tipsOf(const std::vector<ToolLocations>& passes)
{
  pcl::PointCloud<ToolpathPoint> path;
  for (const ToolLocations& pass : passes)
    for (std::size_t i = 0; i < pass.size(); ++i) {
      const double before = path.empty() ? 0.0 : path.back().arc_length;
      ToolpathPoint point;
      point.getVector3fMap() = pass[i].tip.cast<float>();
      point.turn = point.z;
      point.arc_length = before + (i == 0 ? 0.0 : (pass[i].tip - pass[i - 1].tip).norm()); // the tool is lifted between passes
      if (std::isfinite(point.arc_length))
        path.push_back(point);
    }
  return path;
}

/** Points of the scan: red where the ball stays more than 0.1 mm off. */
static pcl::PointCloud<pcl::PointXYZRGB>::Ptr
cutPoints(const Scan& scan, const std::vector<ToolLocations>& passes, double& share)
{
  pcl::PointCloud<pcl::PointXYZ>::Ptr centres(new pcl::PointCloud<pcl::PointXYZ>);
  for (const ToolLocations& pass : passes)
    for (const ToolLocation& l : pass)
      if (const Eigen::Vector3f c = (l.tip + ball * l.axis).cast<float>(); c.allFinite())
        centres->emplace_back(c.x(), c.y(), c.z());
  pcl::KdTreeFLANN<pcl::PointXYZ> tree;
  tree.setInputCloud(centres);
  const pcl::PointCloud<pcl::PointXYZRGB>::Ptr points(new pcl::PointCloud<pcl::PointXYZRGB>);
  pcl::Indices nearest;
  std::vector<float> squares;
  for (const pcl::PointXYZ& p : *scan.cloud) {
    tree.nearestKSearch(p, 1, nearest, squares);
    const bool cut = std::sqrt(squares[0]) < ball + 0.1;
    points->emplace_back(p.x, p.y, p.z, cut ? 140 : 215, cut ? 150 : 25, cut ? 165 : 25);
    share += cut ? 0.0 : 1.0 / static_cast<double>(scan.cloud->size());
  }
  return points;
}

int
main(int argc, char** argv)
{
  if (const std::string fault = displayFault(); argc != 2 || !fault.empty()) // without a display PCLVisualizer would end the program
    return std::fprintf(stderr, "usage: xvfb-run -a %s column.pcd; %s\n", argv[0], fault.c_str());
  const Scan scan = readCloud(argv[1]);
  Viewer viewer("column");
  viewer.setSize(1500, 520);
  const std::vector<ToolLocations> passes[]{located(scan, DriveKind::Helix, Eigen::Vector3d::UnitZ()),
                                            located(scan, DriveKind::Planes, Eigen::Vector3d::UnitZ()),
                                            located(scan, DriveKind::Planes, Eigen::Vector3d::UnitX())};
  const char* names[]{"helix", "planes, axis 0,0,1", "planes, axis 1,0,0"};
  for (int k = 0; k < 3; ++k) {
    int port = 0;
    double share = 0.0;
    viewer.createViewPort(k / 3.0, 0.0, (k + 1) / 3.0, 1.0, port);
    viewer.setBackgroundColor(1.0, 1.0, 1.0, port);
    viewer.addPointCloud<pcl::PointXYZRGB>(cutPoints(scan, passes[k], share), names[k], port);
    viewer.setPointCloudRenderingProperties(pcl::visualization::PCL_VISUALIZER_POINT_SIZE, 3, names[k], port);
    addToolpath(viewer, tipsOf(passes[k]), std::vector<BoundaryLoop>(), std::vector<Polyline>(), std::to_string(k), port);
    viewer.addText(std::string(names[k]) + ": " + std::to_string(std::lround(100.0 * share)) + " % not cut", 10, 10, 20, 0, 0, 0,
                   "share" + std::to_string(k), port);
    std::printf("%s: %.2f %% not cut\n", names[k], 100.0 * share);
  }
  viewer.setCameraPosition(80, -150, 75, 0, 0, 18, 0, 0, 1);
  viewer.spinOnce();
  viewer.saveScreenshot("column_passes.png");
  return 0;
}
