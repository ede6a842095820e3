// SPDX-License-Identifier: BSD-3-Clause
#include "tool_leads.h"

#include <pcl_spiral/core/impl/angles.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {

ProgramBlock
blockTo(const Kinematics& kinematics, const Eigen::Vector3d& tip, const MachineLocation& at, BlockSection section, bool rapid)
{
  ProgramBlock block;
  block.section = section;
  block.rapid = rapid;
  block.tip = tip;
  block.axis = kinematics.toolAxis(at.angles);
  block.normal = at.pose.normal;
  block.machine = kinematics.programmed(tip, at.angles);
  block.angles = at.angles;
  block.arc_length = at.arc_length;
  return block;
}

std::vector<ProgramBlock>
ToolLeads::blocksOf(const std::vector<LeadPlace>& places, const MachineLocation& at) const
{
  std::vector<ProgramBlock> blocks;
  blocks.reserve(places.size());
  for (const LeadPlace& place : places)
    blocks.push_back(blockTo(kinematics_, place.tip, at, place.section, place.rapid));
  return blocks;
}

/** The pose at \p at, with the tool axis as the machine holds it. */
ToolPose
ToolLeads::poseOf(const MachineLocation& at) const
{
  ToolPose pose = at.pose;
  pose.axis = kinematics_.toolAxis(at.angles);
  return pose;
}

std::vector<ProgramBlock>
ToolLeads::entry(const MachineLocation& at, const Eigen::Vector3d& travel) const
{
  return blocksOf(ways_.entry(poseOf(at), travel), at);
}

std::vector<ProgramBlock>
ToolLeads::exit(const MachineLocation& at, const Eigen::Vector3d& travel) const
{
  return blocksOf(ways_.exit(poseOf(at), travel), at);
}

std::vector<ProgramBlock>
ToolLeads::unwinding(const ProgramBlock& at, double to) const
{
  // Without RTCP the machine moves on a chord, not on the circle of the turning work: off by distance (1 - cos(step / 2)).
  const RotaryAxis& table = kinematics_.machine().rotary[0];
  const double distance = (at.tip + kinematics_.machine().work_zero - table.point).cross(table.direction).norm();
  const double share = std::min(1.0, 0.25 * settings_.rapid_height / std::max(distance, 1e-9));
  const double step = kinematics_.machine().rtcp ? quarter_turn : std::min(quarter_turn, 2.0 * std::acos(1.0 - share));
  const int steps = static_cast<int>(std::ceil(std::abs(to - at.angles.first) / step));
  MachineLocation turned;
  turned.pose.normal = at.normal;
  turned.arc_length = at.arc_length;
  std::vector<ProgramBlock> blocks;
  for (int i = 1; i <= steps; ++i) {
    turned.angles = {at.angles.first + (to - at.angles.first) * i / steps, at.angles.second};
    blocks.push_back(blockTo(kinematics_, at.tip, turned, BlockSection::Unwind, true));
  }
  return blocks;
}

} // namespace pcl_spiral
