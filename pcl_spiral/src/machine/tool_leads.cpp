// SPDX-License-Identifier: BSD-3-Clause
#include "tool_leads.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr double quarter_turn = 1.57079632679489661923;

} // namespace

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

/** From the far end of the lead to the path; \p inward is the direction of travel onto
 *  the path. */
std::vector<Eigen::Vector3d>
ToolLeads::leadTips(const MachineLocation& at, const Eigen::Vector3d& inward) const
{
  const Eigen::Vector3d& normal = at.pose.normal;
  const Eigen::Vector3d along = inward - inward.dot(normal) * normal;
  const double radius = settings_.lead_length;
  if (settings_.lead == LeadKind::Normal || along.norm() < 1e-9)
    return {at.pose.tip + radius * normal, at.pose.tip};
  // Sagitta of a step: radius (1 - cos(step / 2)).
  const double share = std::min(1.0, settings_.block.tip / radius);
  const int steps = std::max(4, static_cast<int>(std::ceil(quarter_turn / (2.0 * std::acos(1.0 - share)))));
  std::vector<Eigen::Vector3d> tips;
  for (int i = 0; i <= std::min(steps, 1000); ++i) {
    const double angle = quarter_turn * (1.0 - static_cast<double>(i) / std::min(steps, 1000));
    tips.push_back(at.pose.tip + radius * ((1.0 - std::cos(angle)) * normal - std::sin(angle) * along.normalized()));
  }
  return tips;
}

/** Along the tool axis to the clearance, on to the rapid height, then up to the top. */
std::vector<Eigen::Vector3d>
ToolLeads::climb(const Eigen::Vector3d& from, const Eigen::Vector3d& axis) const
{
  const Eigen::Vector3d clear = from + settings_.clearance * axis;
  const Eigen::Vector3d high = clear + settings_.rapid_height * axis;
  return {clear, high, high + std::max(0.0, top_ - high.dot(up_)) * up_};
}

std::vector<ProgramBlock>
ToolLeads::entry(const MachineLocation& at, const Eigen::Vector3d& travel) const
{
  const std::vector<Eigen::Vector3d> lead = leadTips(at, travel);
  const std::vector<Eigen::Vector3d> way = climb(lead.front(), kinematics_.toolAxis(at.angles));
  std::vector<ProgramBlock> blocks;
  const auto add = [&](const Eigen::Vector3d& tip, BlockSection section, bool rapid) {
    blocks.push_back(blockTo(kinematics_, tip, at, section, rapid));
  };
  add(way[2], BlockSection::Position, true);
  add(way[1], BlockSection::Approach, true);
  add(way[0], BlockSection::Approach, true);
  add(lead.front(), BlockSection::Approach, false);
  for (std::size_t i = 1; i < lead.size(); ++i)
    add(lead[i], BlockSection::LeadIn, false);
  return blocks;
}

std::vector<ProgramBlock>
ToolLeads::exit(const MachineLocation& at, const Eigen::Vector3d& travel) const
{
  const std::vector<Eigen::Vector3d> lead = leadTips(at, -travel);
  std::vector<ProgramBlock> blocks;
  const auto add = [&](const Eigen::Vector3d& tip, BlockSection section, bool rapid) {
    blocks.push_back(blockTo(kinematics_, tip, at, section, rapid));
  };
  for (std::size_t i = lead.size() - 1; i-- > 0;)
    add(lead[i], BlockSection::LeadOut, false);
  const std::vector<Eigen::Vector3d> way = climb(lead.front(), kinematics_.toolAxis(at.angles));
  add(way[0], BlockSection::Retract, false);
  add(way[1], BlockSection::Retract, true);
  add(way[2], BlockSection::Retract, true);
  return blocks;
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
