// SPDX-License-Identifier: BSD-3-Clause
#include "block_times.h"
#include "half_turn.h"
#include "lead_ways.h"

#include <pcl_spiral/machine/impl/kinematics.h>
#include <pcl_spiral/machine/tool_moves.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

constexpr double same_place = 1e-9; // mm

Eigen::Vector3d
upOf(const std::vector<ToolPoses>& passes)
{
  bool upright = true;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const ToolPoses& pass : passes)
    for (const ToolPose& pose : pass) {
      upright = upright && pose.axis.z() >= 0.0;
      sum += pose.axis;
    }
  return upright || !(sum.norm() > 1e-6) ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d(sum.normalized());
}

/** Height of the highest tip, or of \p box, along \p up. */
double
topOf(const std::vector<ToolPoses>& passes, const Eigen::AlignedBox3d& box, const Eigen::Vector3d& up)
{
  double top = box.isEmpty() ? -std::numeric_limits<double>::infinity() : box.center().dot(up) + 0.5 * box.sizes().dot(up.cwiseAbs());
  for (const ToolPoses& pass : passes)
    for (const ToolPose& pose : pass)
      top = std::max(top, pose.tip.dot(up));
  return top;
}

/** Direction of travel from \p from to \p to; zero if the contact stays. */
Eigen::Vector3d
travelBetween(const ToolPose& from, const ToolPose& to)
{
  const Eigen::Vector3d way = to.contact - from.contact;
  return way.norm() > 0.0 ? Eigen::Vector3d(way.normalized()) : way;
}

ToolPose
movedTo(const Eigen::Vector3d& tip, const ToolPose& pose)
{
  return {tip, pose.axis, pose.contact + tip - pose.tip, pose.normal};
}

/** The moves of one pass. */
class PassMoves {
public:
  explicit PassMoves(const ProgramSettings& settings) : settings_(settings) {}

  /** Adds moves off the path, with the axis of \p end. */
  void lead(const std::vector<LeadPlace>& places, const ToolPose& end)
  {
    for (const LeadPlace& place : places)
      if (moves_.empty() || (place.tip - moves_.back().pose.tip).norm() > same_place)
        add(place.section, place.rapid, movedTo(place.tip, end));
  }

  void cut(const ToolPose& pose) { add(BlockSection::Cut, false, pose); }

  ToolMoves take() { return std::move(moves_); }

private:
  void add(BlockSection section, bool rapid, const ToolPose& pose)
  {
    ToolMove move{section, rapid, pose, 0.0};
    if (!rapid && !moves_.empty()) {
      const ToolPose& before = moves_.back().pose;
      const double contact = section == BlockSection::Cut ? (pose.contact - before.contact).norm() : 0.0;
      const Eigen::Vector3d tip = pose.tip - before.tip, centre = tip + settings_.ball_radius * (pose.axis - before.axis);
      move.minutes = countedWay(contact, std::max(tip.norm(), centre.norm())) / feedOf(settings_, section);
    }
    moves_.push_back(move);
  }

  const ProgramSettings& settings_;
  ToolMoves moves_;
};

} // namespace

std::vector<ToolMoves>
ledPasses(const std::vector<ToolPoses>& passes, const ProgramSettings& settings)
{
  const Eigen::Vector3d up = upOf(passes);
  const LeadWays ways(settings, up, topOf(passes, settings.clear_box, up) + settings.rapid_height);
  std::vector<ToolMoves> all;
  for (const ToolPoses& pass : passes) {
    if (pass.empty())
      continue;
    PassMoves moves(settings);
    const ToolPose &first = pass.front(), &last = pass.back();
    moves.lead(ways.entry(first, travelBetween(first, pass[std::min<std::size_t>(1, pass.size() - 1)])), first);
    for (std::size_t i = 1; i < pass.size(); ++i)
      moves.cut(pass[i]);
    moves.lead(ways.exit(last, travelBetween(pass[pass.size() < 2 ? 0 : pass.size() - 2], last)), last);
    all.push_back(moves.take());
  }
  return all;
}

ToolMoves
movesOf(const MachineProgram& program)
{
  ToolMoves moves;
  for (const ProgramBlock& block : program.blocks)
    if (block.section != BlockSection::Unwind)
      moves.push_back({block.section, block.rapid, {block.tip, block.axis, block.tip, block.normal}, block.minutes});
  return moves;
}

MachineProgram
programOf(const std::vector<ToolMoves>& passes)
{
  const Kinematics kinematics(xyzacTrunnion());
  MachineProgram program;
  program.machine = kinematics.machine();
  RotaryAngles angles;
  for (const ToolMoves& pass : passes)
    for (const ToolMove& move : pass) {
      if (const std::optional<RotaryAngles> found = kinematics.anglesOf(move.pose.axis, Branch::Larger)) {
        angles.first = std::isnan(found->first) ? angles.first : nearestTurn(found->first, angles.first);
        angles.second = found->second;
      }
      ProgramBlock block;
      block.section = move.section;
      block.rapid = move.rapid;
      block.tip = move.pose.tip;
      block.axis = move.pose.axis;
      block.normal = move.pose.normal;
      block.machine = kinematics.programmed(block.tip, angles);
      block.angles = angles;
      block.minutes = move.minutes;
      program.blocks.push_back(block);
    }
  return program;
}

} // namespace pcl_spiral
