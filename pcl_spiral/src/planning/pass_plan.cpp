// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/planning/pass_plan.h>

#include "drive/pass_axes.h"
#include <pcl_spiral/common/impl/thread_limit.h>

#include <algorithm>
#include <utility>

namespace pcl_spiral {

std::vector<Setting>
settingTable(PassSettings& s)
{
  return {
      Setting(
          "ceiling", "PassSettings::ceiling", "ceiling",
          "the cutter comes from this far above the surface, along its axis: what is higher, such as the opposite wall of a bore, does not "
          "lift it; a tool without a holder is ten radii long, without limit if its axis is fixed",
          "60", s.ceiling)
          .in("mm", NumberRange::from(0.0))
          .zeroFor("the length of the tool"),
      Setting("tolerance", "PassSettings::tolerance", "tolerance",
              "adds points until no straight move gouges more or leaves more than this", "0.005", s.tolerance)
          .in("mm", NumberRange::from(least_tolerance)),
      Setting("axis_smoothing", "PassSettings::axis_smoothing", "smoothing length of the axis",
              "smooths changes of the axis shorter than this along a pass, by up to 20 deg on average", "20", s.axis_smoothing)
          .in("mm", NumberRange::from(0.0))
          .zeroFor("no smoothing"),
      Setting("max_retilt", "PassSettings::max_retilt", "largest retilt",
              "where the holder would collide, or the cutter be lifted off its contact on a mesh, turn the axis by up to this", "30",
              s.max_retilt)
          .in("degrees", NumberRange::from(0.0).upTo(90.0))
          .zeroFor("no turn"),
      Setting("retilt_step", "PassSettings::retilt_step", "step of the retilt",
              "largest change of that turn from one point of a pass to the next", "1", s.retilt_step)
          .in("degrees", NumberRange::above(0.0).upTo(180.0)),
      Setting("max_axis_rate", "PassSettings::max_axis_rate", "largest axis rate", "largest turn of the axis per mm of path", "4",
              s.max_axis_rate)
          .in("degrees/mm", NumberRange::from(0.0))
          .zeroFor("no limit"),
      Setting("holder_clearance", "setHolderClearance", "clearance of the holder", "least distance between holder and scan", "1",
              s.holder_clearance)
          .in("mm", NumberRange::from(0.0))
          .writtenBy("holder-clearance"),
      threadsSetting(s.threads).writtenBy("threads"),
  };
}

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
