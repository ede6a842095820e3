// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/planning/pass_plan.h>

#include "drive/pass_axes.h"

#include <algorithm>
#include <utility>

namespace pcl_spiral {

PassPath
joinedPasses(const std::vector<ToolPoses>& passes)
{
  PassPath all;
  double length = 0.0;
  for (std::size_t pass = 0; pass < passes.size(); ++pass) {
    if (pass > 0)
      all.begins.push_back(all.path.size());
    const ToolPose* before = nullptr;
    for (const ToolPose& pose : passes[pass]) {
      length += before ? (pose.contact - before->contact).norm() : 0.0;
      before = &pose;
      ToolpathPoint p;
      p.getVector3fMap() = pose.contact.cast<float>();
      p.getNormalVector3fMap() = pose.normal.cast<float>();
      p.getAxisVector3fMap() = pose.axis.cast<float>();
      p.arc_length = length;
      p.turn = static_cast<float>(pass);
      all.path.push_back(p);
      all.tips.push_back(pose.tip);
    }
  }
  return all;
}

std::vector<ToolPoses>
beamPasses(const DrivePasses& rows, double stand_off)
{
  std::vector<ToolPoses> passes;
  for (const DrivePass& row : rows) {
    ToolPoses poses;
    const auto add = [&](const DrivePoint& p) {
      const Eigen::Vector3d axis = p.axis.normalized();
      poses.push_back({p.position, axis, p.position - beamReach(p, stand_off) * axis, p.normal});
    };
    std::for_each(row.points.begin(), row.points.end(), add);
    if (row.closed)
      add(row.points.front());
    passes.push_back(std::move(poses));
  }
  return passes;
}

} // namespace pcl_spiral
