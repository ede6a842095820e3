// SPDX-License-Identifier: BSD-3-Clause
// Every stage from a cloud of points of our own to tool axes, against what is known of a dome.
#include "scanner_point.h"

#include <pcl_spiral/features/boundary_loops.h>
#include <pcl_spiral/geodesic/geodesic_path.h>
#include <pcl_spiral/spiral/radial_lines.h>
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>
#include <pcl_spiral/spiral/tool_axis.h>
#include <pcl_spiral/surface/mls_projector.h>
#include <pcl_spiral/surface/surface_preparation.h>

#include <cmath>
#include <iostream>

namespace {

bool
holds(const char* stage, bool right, const pcl_spiral::Status& status)
{
  std::cout << "c_and_cxx: " << stage << (right ? " is right" : " is wrong") << ", " << status.message() << '\n';
  return right;
}

bool
preparationIsRight(const ScannerCloud::Ptr& dome)
{
  pcl_spiral::SurfacePreparation<ScannerPoint> preparation;
  preparation.setInputCloud(dome);
  ScannerCloud cloud;
  pcl::PointCloud<pcl::Normal> normals;
  preparation.compute(cloud, normals);
  bool right = cloud.size() == dome->size() && normals.size() == dome->size();
  for (std::size_t i = 0; right && i < cloud.size(); ++i)
    right = cloud[i].confidence == 1.0f && normals[i].normal_z > 0.0f;
  return holds("SurfacePreparation", right, preparation.getStatus());
}

bool
loopsAreRight(const ScannerCloud::Ptr& dome, double rim)
{
  pcl_spiral::BoundaryLoops<ScannerPoint> boundary;
  boundary.setInputCloud(dome);
  std::vector<pcl_spiral::BoundaryLoop> loops;
  boundary.compute(loops);
  const bool right = loops.size() == 1 && std::abs(loops[0].length - 2.0 * M_PI * rim) < 0.02 * 2.0 * M_PI * rim;
  return holds("BoundaryLoops", right, boundary.getStatus());
}

bool
geodesicIsRight(const ScannerCloud::Ptr& dome, double radius)
{
  const double angle = 0.4;
  pcl_spiral::GeodesicPath<ScannerPoint> geodesic;
  geodesic.setInputCloud(dome);
  geodesic.setSourcePoint({0.0, 0.0, radius});
  geodesic.setTargetPoints({{radius * std::sin(angle), 0.0, radius * std::cos(angle)}});
  std::vector<pcl_spiral::Polyline> paths;
  geodesic.compute(paths);
  const bool right = paths.size() == 1 && std::abs(pcl_spiral::length(paths[0]) - radius * angle) < 0.01;
  return holds("GeodesicPath", right, geodesic.getStatus());
}

bool
projectorIsRight(const ScannerCloud::Ptr& dome, double radius)
{
  ScannerCloud::Ptr above(new ScannerCloud);
  for (std::size_t i = 0; i < dome->size() / 2; i += 50) { // the sunflower's first half is well inside
    above->push_back((*dome)[i]);
    above->back().getVector3fMap() *= 1.01f;
  }
  pcl_spiral::MLSProjector<ScannerPoint, ScannerPoint> projector;
  projector.setInputCloud(dome);
  projector.setQueryCloud(above);
  ScannerCloud feet;
  projector.compute(feet);
  bool right = feet.size() == above->size();
  for (const ScannerPoint& foot : feet)
    right = right && std::abs(foot.getVector3fMap().norm() - radius) < 0.01;
  return holds("MLSProjector", right, projector.getStatus());
}

bool
linesAreRight(const ScannerCloud::Ptr& dome, double radius, double rim)
{
  pcl_spiral::RadialLines<ScannerPoint> radial;
  radial.setInputCloud(dome);
  radial.setCenter({0.0, 0.0, radius});
  std::vector<pcl_spiral::RadialLine> lines;
  radial.compute(lines);
  bool right = lines.size() > 8;
  for (const pcl_spiral::RadialLine& line : lines)
    right = right && std::abs(line.length() - radius * std::asin(rim / radius)) < 1.0;
  return holds("RadialLines", right, radial.getStatus());
}

bool
spiralIsRight(const ScannerCloud::Ptr& dome, double radius)
{
  pcl_spiral::SpiralToolpathGenerator<ScannerPoint> spiral;
  spiral.setInputCloud(dome);
  spiral.setToolRadius(6.0);
  spiral.setScallopHeight(0.1);
  spiral.setChordError(0.01);
  pcl_spiral::ToolAxis::Path::Ptr path(new pcl_spiral::ToolAxis::Path);
  spiral.compute(*path);
  bool right = path->size() > 100;
  for (const pcl_spiral::ToolpathPoint& p : *path)
    right = right && std::abs(p.getVector3fMap().norm() - radius) < 0.05;
  if (!holds("SpiralToolpathGenerator", right, spiral.getStatus()))
    return false;

  pcl_spiral::ToolAxis tool_axis;
  tool_axis.setInputPath(path);
  tool_axis.setTiltAngle(0.0);
  tool_axis.setAxisSmoothing(0.0);
  pcl_spiral::ToolAxis::Path upright;
  tool_axis.compute(upright);
  right = upright.size() == path->size();
  for (const pcl_spiral::ToolpathPoint& p : upright)
    right = right && (p.getAxisVector3fMap() - p.getNormalVector3fMap()).norm() < 1e-5f;
  return holds("ToolAxis", right, tool_axis.getStatus());
}

} // namespace

bool
stagesAreRight(const ScannerCloud::Ptr& dome, double radius, double rim)
{
  return preparationIsRight(dome) && loopsAreRight(dome, rim) && geodesicIsRight(dome, radius) && projectorIsRight(dome, radius) &&
         linesAreRight(dome, radius, rim) && spiralIsRight(dome, radius);
}
