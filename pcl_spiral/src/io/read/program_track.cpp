// SPDX-License-Identifier: BSD-3-Clause
#include "program_track.h"

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/impl/angles.h>

#include <cmath>

namespace pcl_spiral {
namespace {

/** \p angle plus or minus whole turns, nearest to \p near. */
double
turnedTo(double angle, double near)
{
  return angle - full_turn * std::round((angle - near) / full_turn);
}

bool
isWithin(double angle, const AxisRange& range)
{
  constexpr double rounding = 1e-6;
  return angle >= range.lower - rounding && angle <= range.upper + rounding;
}

using Coordinates = std::array<std::optional<double>, 3>;

bool
allOf(const Coordinates& xyz)
{
  return xyz[0] && xyz[1] && xyz[2];
}

Eigen::Vector3d
vectorOf(const Coordinates& xyz)
{
  return {*xyz[0], *xyz[1], *xyz[2]};
}

} // namespace

ProgramTrack::ProgramTrack(const Machine& machine, bool in_workpiece) : kinematics_(machine), in_workpiece_(in_workpiece)
{
  if (machine.three_axes)
    angles_ = {0.0, 0.0};
  file_.program.machine = kinematics_.machine();
}

Diagnostic
ProgramTrack::turnTo(const Eigen::Vector3d& axis)
{
  const auto& rotary = kinematics_.machine().rotary;
  const RotaryAngles from{angles_[0].value_or(rotary[0].home), angles_[1].value_or(rotary[1].home)};
  std::optional<RotaryAngles> best;
  double least = 0.0;
  for (Branch branch : {Branch::Larger, Branch::Smaller}) {
    const std::optional<RotaryAngles> found = kinematics_.anglesOf(axis, branch);
    if (!found)
      return Diagnostic("no angles of ", rotary[0].letter, " and ", rotary[1].letter, " reach the tool axis ", Direction(axis),
                        "; give the machine file for which the program was made");
    const RotaryAngles angles{std::isnan(found->first) ? from.first : turnedTo(found->first, from.first),
                              turnedTo(found->second, from.second)};
    constexpr double beyond = 1e3; // radians: an angle beyond the limits is used only if there is no other
    const double way = std::abs(angles.first - from.first) + std::abs(angles.second - from.second) +
                       (isWithin(angles.second, rotary[1].range) ? 0.0 : beyond);
    if (!best || way < least) {
      best = angles;
      least = way;
    }
  }
  angles_ = {best->first, best->second};
  return {};
}

/** The place of the machine that belongs to the tip. */
void
ProgramTrack::placeMachine()
{
  if (!allOf(tip_) || !angles_[0] || !angles_[1])
    return;
  const Eigen::Vector3d place = kinematics_.programmed(vectorOf(tip_), {*angles_[0], *angles_[1]});
  machine_ = {place.x(), place.y(), place.z()};
}

void
ProgramTrack::goTo(const ProgramTarget& target)
{
  const Machine& machine = kinematics_.machine();
  const bool tips = target.of_tip && (!target.of_machine || in_workpiece_);
  const Eigen::Vector3d shift = machine.work_zero + Eigen::Vector3d(0.0, 0.0, machine.tool_length);
  if (target.of_machine && tips && !begun())
    return; // from the present place of the machine, which is not known
  if (target.of_tip)
    placeMachine(); // the tip stays while the rotary axes turn
  for (std::size_t i = 0; i < 3; ++i)
    if (target.xyz[i])
      (tips ? tip_ : machine_)[i] = *target.xyz[i] - (target.of_machine ? shift[static_cast<int>(i)] : 0.0);
  if (tips)
    placeMachine();
  else if (allOf(machine_) && angles_[0] && angles_[1]) {
    const Eigen::Vector3d tip = kinematics_.tipOf(vectorOf(machine_), {*angles_[0], *angles_[1]});
    tip_ = {tip.x(), tip.y(), tip.z()};
  }
}

Diagnostic
ProgramTrack::move(std::size_t line, const ProgramTarget& target)
{
  for (std::size_t i = 0; i < 2; ++i)
    if (target.angles[i])
      angles_[i] = target.angles[i];
  if (target.axis)
    if (const Diagnostic fault = turnTo(*target.axis); !fault.empty())
      return fault;
  goTo(target);
  const bool known = allOf(tip_) && allOf(machine_) && angles_[0] && angles_[1];
  if (!target.rapid && !begun())
    return "the place from which this feed move starts is not known; go there with a G0 that names all five axes";
  if (!target.rapid && !(target.feed > 0.0))
    return target.inverse_time ? "with G93 every feed move needs an F above 0, and the control stops here; give F"
                               : "no feed is set, and the control stops here; give F";
  if (known)
    add(line, target);
  return {};
}

double
ProgramTrack::fedWay(const ProgramBlock& block, const ProgramTarget& target) const
{
  const ProgramBlock& before = file_.program.blocks.back();
  const double way = kinematics_.machine().rtcp ? (block.tip - before.tip).norm() : (block.machine - before.machine).norm();
  const double turn = in_degrees * std::hypot(block.angles.first - before.angles.first, block.angles.second - before.angles.second);
  return way > 0.0 ? std::hypot(way / target.unit, target.counts_degrees ? turn : 0.0) : turn;
}

void
ProgramTrack::add(std::size_t line, const ProgramTarget& target)
{
  std::vector<ProgramBlock>& blocks = file_.program.blocks;
  ProgramBlock block;
  block.rapid = target.rapid;
  block.section = target.rapid ? BlockSection::Position : target.link ? BlockSection::Link : BlockSection::Cut;
  block.angles = {*angles_[0], *angles_[1]};
  block.tip = vectorOf(tip_);
  block.machine = vectorOf(machine_);
  block.axis = target.axis ? target.axis->normalized() : kinematics_.toolAxis(block.angles);
  block.normal = block.axis;
  file_.by_vectors = file_.by_vectors || target.axis;
  const double way = blocks.empty() ? 0.0 : (block.tip - blocks.back().tip).norm();
  block.arc_length = blocks.empty() ? 0.0 : blocks.back().arc_length + way;
  if (!target.rapid)
    block.minutes = target.inverse_time ? 1.0 / target.feed : fedWay(block, target) / target.feed;
  blocks.push_back(block);
  file_.lines.push_back(line);
}

} // namespace pcl_spiral
