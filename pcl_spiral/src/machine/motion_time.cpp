// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/machine/motion_time.h>

#include "control_moves.h"

#include "core/motion_timer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

constexpr double feed_step = 1.5, acceleration_step = 2.0, tolerance_step = 2.0; ///< of MotionChange

double
cornerTolerance(const MachineProgram& program, const ControlModel& control, std::optional<double> tolerance)
{
  return program.machine.path_tolerance.value_or(tolerance.value_or(control.tolerance));
}

/** The first block that has no finite place or time; the number of blocks if all have. */
std::size_t
firstBadBlock(const MachineProgram& program)
{
  const auto bad = std::find_if(program.blocks.begin(), program.blocks.end(), [](const ProgramBlock& block) {
    return !block.tip.allFinite() || !block.machine.allFinite() || !std::isfinite(block.angles.first) ||
           !std::isfinite(block.angles.second) || !(block.minutes >= 0.0) || !std::isfinite(block.minutes);
  });
  return static_cast<std::size_t>(bad - program.blocks.begin());
}

MotionTime
timeOf(const std::vector<ControlMove>& moves, std::size_t blocks, const ControlModel& control, const AxisDynamics& axes, double tolerance)
{
  MotionTime time;
  time.blocks.assign(blocks, 0.0);
  const std::vector<double> ends = MotionTimer(control, axes, tolerance).ends(moves);
  for (std::size_t i = 0; i < moves.size(); ++i) {
    time.blocks[moves[i].block] = ends[i] - time.seconds;
    time.seconds = ends[i];
  }
  return time;
}

MotionTime
timeOf(const MachineProgram& program, const ControlModel& control, const AxisDynamics& axes, double tolerance)
{
  return timeOf(controlMoves(program, control, axes), program.blocks.size(), control, axes, tolerance);
}

AxisDynamics
dynamicsFor(const MachineProgram& program, const ControlModel& control)
{
  AxisDynamics axes = dynamicsOf(program.machine);
  if (!control.takes_jerk)
    axes.jerk.setConstant(std::numeric_limits<double>::infinity());
  return axes;
}

double
secondsAtFeed(const std::vector<ControlMove>& moves)
{
  double seconds = 0.0;
  for (const ControlMove& move : moves)
    seconds += move.length / move.speed;
  return seconds;
}

/** \p control with corners of rotary moves as it would round them. */
ControlModel
withRoundedTurns(ControlModel control)
{
  if (control.rotary_corner == CornerRule::Overlap || control.rotary_corner == CornerRule::Stop)
    control.rotary_corner = CornerRule::AxisRounding;
  return control;
}

/** \p moves: of the program. */
MotionLosses
lossesOf(const std::vector<ControlMove>& moves, const MotionStudy& study, const AxisDynamics& axes)
{
  const std::size_t blocks = study.time.blocks.size();
  const auto with = [&](const ControlModel& control) { return timeOf(moves, blocks, control, axes, study.tolerance).seconds; };
  MotionLosses losses;
  const bool turns = std::any_of(moves.begin(), moves.end(), [](const ControlMove& move) { return move.turns; });
  ControlModel control = turns ? withRoundedTurns(study.control) : study.control;
  const double rounded = with(control);
  control.look_ahead = blocks * 2;
  control.least_cycles = 0.0;
  const double seen = with(control);
  control.corner = control.rotary_corner = CornerRule::Free;
  const double straight = with(control);
  losses.at_feed = secondsAtFeed(moves);
  losses.ramps = straight - losses.at_feed;
  losses.corners = seen - straight;
  losses.short_blocks = rounded - seen;
  losses.rotary = study.time.seconds - rounded;
  return losses;
}

void
addModelGains(const MachineProgram& program, const std::vector<ControlMove>& moves, const AxisDynamics& axes, MotionStudy& study)
{
  const std::size_t blocks = program.blocks.size();
  const std::vector<ControlMove> faster = controlMoves(program, study.control, axes, feed_step);
  addGain(MotionChange::Feed, timeOf(faster, blocks, study.control, axes, study.tolerance).seconds, study);
  AxisDynamics stronger = axes;
  stronger.acceleration *= acceleration_step;
  addGain(MotionChange::Acceleration, timeOf(program, study.control, stronger, study.tolerance).seconds, study);
  if (study.tolerance > 0.0)
    addGain(MotionChange::Tolerance, timeOf(moves, blocks, study.control, axes, tolerance_step * study.tolerance).seconds, study);
  if (study.losses.rotary > 0.0)
    addGain(MotionChange::RotaryBlend, study.time.seconds - study.losses.rotary, study);
}

bool
takesUsualAxes(const Machine& machine)
{
  const auto lacks = [](const AxisRange& range) { return !range.largest_acceleration; };
  return std::any_of(machine.linear.begin(), machine.linear.end(), lacks) ||
         (!machine.three_axes && (lacks(machine.rotary[0].range) || lacks(machine.rotary[1].range)));
}

} // namespace

ControlModel
controlModel(ControlKind kind, const Machine& machine)
{
  ControlModel model = controlModel(kind);
  if (machine.control.look_ahead)
    model.look_ahead = static_cast<std::size_t>(*machine.control.look_ahead);
  if (machine.control.rounds_rotary_corners)
    model.rotary_corner = *machine.control.rounds_rotary_corners ? CornerRule::AxisRounding : CornerRule::Stop;
  return model;
}

std::optional<MotionTime>
motionTime(const MachineProgram& program, const ControlModel& control, std::optional<double> tolerance)
{
  if (firstBadBlock(program) < program.blocks.size())
    return {};
  return timeOf(program, control, dynamicsFor(program, control), cornerTolerance(program, control, tolerance));
}

void
addGain(MotionChange change, double seconds, MotionStudy& study)
{
  study.gains.push_back({change, study.time.seconds - seconds});
  std::stable_sort(study.gains.begin(), study.gains.end(), [](const MotionGain& a, const MotionGain& b) { return a.seconds > b.seconds; });
}

MotionStudy
studyMotion(const MachineProgram& program, const ControlModel& control, std::optional<double> tolerance)
{
  MotionStudy study;
  study.control = control;
  study.tolerance = cornerTolerance(program, control, tolerance);
  study.usual_axes = takesUsualAxes(program.machine);
  if (const std::size_t bad = firstBadBlock(program); bad < program.blocks.size()) {
    study.status = {StatusCode::InvalidInput, Diagnostic("block ", bad,
                                                         " of the program has no finite place, or a time that is not finite "
                                                         "or below 0, so that the machining time is not known; set them")};
    return study;
  }
  const AxisDynamics axes = dynamicsFor(program, control);
  const std::vector<ControlMove> moves = controlMoves(program, control, axes);
  study.time = timeOf(moves, program.blocks.size(), control, axes, study.tolerance);
  study.losses = lossesOf(moves, study, axes);
  addModelGains(program, moves, axes, study);
  study.status = Status::success();
  return study;
}

} // namespace pcl_spiral
