// SPDX-License-Identifier: BSD-3-Clause
#include "pass_scene.h"

#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/drive/impl/drive_cylinder.h>

#include <cmath>

using namespace pcl_spiral;

namespace {

/** Number of turns of a path round an axis. */
void
countTurns(const DriveCylinder& cylinder, pcl::PointCloud<ToolpathPoint>& path)
{
  const Eigen::Vector3d across = referenceAcross(cylinder.direction), up = cylinder.direction.cross(across);
  double turns = 0.0, last = 0.0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Eigen::Vector3d out = path[i].getVector3fMap().cast<double>() - cylinder.origin;
    const double angle = std::atan2(out.dot(up), out.dot(across));
    if (i > 0)
      turns += std::remainder(angle - last, 2.0 * pi) / (2.0 * pi);
    last = angle;
    path[i].turn = static_cast<float>(std::abs(turns));
  }
}

} // namespace

PassScene
passScene(const Job& job, const Result& result, const std::string& title, pcl::PointCloud<ToolpathPoint> path)
{
  PassScene scene;
  scene.title = title;
  scene.cloud = result.cloud;
  scene.mesh = result.mesh;
  if (job.drive.kind == DriveKind::Helix && result.passes.size() == 1 && result.drive.column)
    countTurns(result.drive.column->cylinder, path);
  scene.path = pcl::make_shared<pcl::PointCloud<ToolpathPoint>>(std::move(path));
  scene.cutter = job.cutter;
  scene.step_over = result.drive.step_over;
  return scene;
}
