// SPDX-License-Identifier: BSD-3-Clause
#include "planning/program_warnings.h"

#include <pcl_spiral/core/impl/angles.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace pcl_spiral {
namespace {

constexpr double least_named = 0.001; // degrees that an axis is blended by: at the pole an upright tool keeps it

} // namespace

Diagnostics
programWarnings(const MachineProgram& program)
{
  const ProgramReport& report = program.report;
  const char first = program.machine.rotary[0].letter;
  Diagnostics warnings;
  if (!program.machine.retract_z)
    warnings.push_back(Diagnostic(program.machine.name,
                                  ": no retract_z is given (a machine Z that is clear of everything): the program turns the rotary axes "
                                  "and goes to its first point from the tool's present position; start it above the part"));
  if (!report.poles.empty()) {
    const auto less = [](const PoleZone& a, const PoleZone& b) { return a.largest_change < b.largest_change; };
    const PoleZone& most = *std::max_element(report.poles.begin(), report.poles.end(), less);
    const Diagnostic where = report.poles.size() == 1 ? Diagnostic("from ") : Diagnostic("in ", report.poles.size(), " places, most from ");
    const double degrees = most.largest_change * in_degrees;
    warnings.push_back(Diagnostic("near the pole, ", first, " would turn faster than its limit: the tool axis was blended ", where,
                                  most.begin, " to ", most.end, " {mm} of the path, ",
                                  degrees < least_named ? Diagnostic("by less than ", least_named) : Diagnostic("by up to ", degrees),
                                  " {degrees}"));
  }
  if (const std::size_t by_axis = report.slowed_blocks - report.tool_slowed_blocks; by_axis > 0)
    warnings.push_back(Diagnostic(by_axis, " of ", report.cut_blocks, by_axis == 1 ? " blocks runs below" : " blocks run below",
                                  " the feed because of the rate limit of an axis, the slowest at ", 100.0 * report.least_feed_share,
                                  " % of it, at ", report.least_feed_at, " {mm} of the path"));
  if (report.tool_slowed_blocks > 0)
    warnings.push_back(Diagnostic(report.tool_slowed_blocks, " of ", report.cut_blocks,
                                  report.tool_slowed_blocks == 1 ? " blocks runs below" : " blocks run below",
                                  " the feed because the tool moves more than twice as far as its contact; it keeps to twice "
                                  "the feed"));
  if (!report.unwound_at.empty())
    warnings.push_back(Diagnostic("the tool leaves the surface ", report.unwound_at.size(), " times so that ", first,
                                  " can unwind at its limit, first at ", report.unwound_at.front(), " {mm} of the path"));
  return warnings;
}

Status
checkBeam(const MachineProgram& program)
{
  constexpr double least_share = 0.5; // share of the feed
  const ProgramReport& report = program.report;
  if (report.slowed_blocks == 0 || report.least_feed_share >= least_share)
    return Status::success();
  const auto slowest = std::min_element(program.blocks.begin(), program.blocks.end(), [&](const ProgramBlock& a, const ProgramBlock& b) {
    return std::abs(a.arc_length - report.least_feed_at) < std::abs(b.arc_length - report.least_feed_at);
  });
  return {
      StatusCode::Failed,
      Diagnostic("at ", Place(slowest->tip), " the rotary axes turn so far that the beam moves at only ", 100.0 * report.least_feed_share,
                 " % of the feed while it is on, and would burn the part: tilt the beam "
                 "({RidgeRowSettings::tilt} 20), or turn the part on the machine, so that the tool axis stays away from the direction of ",
                 std::string(1, program.machine.rotary[0].letter))};
}

} // namespace pcl_spiral
