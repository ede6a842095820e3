// SPDX-License-Identifier: BSD-3-Clause
#include "block_times.h"

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr double largest_step = 0.05; ///< of a rotary axis between two looks at the linear axes, radians

/** The way that the feed counts in a block; see setBlockTimes. */
double
wayOfBlock(const ProgramBlock& a, const ProgramBlock& b, double ball_radius)
{
  const Eigen::Vector3d tip = b.tip - a.tip;
  const double tool = std::max(tip.norm(), (tip + ball_radius * (b.axis - a.axis)).norm());
  return countedWay(b.arc_length - a.arc_length, tool);
}

/** Speed of the linear axes at share \p s of the block, in blocks. */
Eigen::Vector3d
linearSpeed(const Kinematics& kinematics, const ProgramBlock& a, const ProgramBlock& b, double s)
{
  constexpr double step = 1e-3;
  const auto at = [&](double share) {
    return kinematics.programmed(a.tip + share * (b.tip - a.tip), {a.angles.first + share * (b.angles.first - a.angles.first),
                                                                   a.angles.second + share * (b.angles.second - a.angles.second)});
  };
  return (at(s + step) - at(s - step)) / (2.0 * step);
}

/** The time the slowest axis needs from \p a to \p b. */
double
axisTime(const Kinematics& kinematics, const ProgramBlock& a, const ProgramBlock& b)
{
  const Machine& machine = kinematics.machine();
  const double first = std::abs(b.angles.first - a.angles.first), second = std::abs(b.angles.second - a.angles.second);
  double minutes = std::max(first / machine.rotary[0].range.largest_rate, second / machine.rotary[1].range.largest_rate);
  const auto count = [&](const Eigen::Vector3d& speed) {
    for (int i = 0; i < 3; ++i)
      minutes = std::max(minutes, std::abs(speed[i]) / machine.linear[i].largest_rate);
  };
  count(b.machine - a.machine);
  const double turn = std::max(first, second);
  if (!machine.rtcp || turn == 0.0)
    return minutes; // the linear axes move evenly
  const int steps = static_cast<int>(std::ceil(turn / largest_step));
  for (int i = 0; i <= steps; ++i)
    count(linearSpeed(kinematics, a, b, static_cast<double>(i) / steps));
  return minutes;
}

} // namespace

double
feedOf(const ProgramSettings& settings, BlockSection section)
{
  const auto own = [&](double feed) { return feed > 0.0 ? feed : settings.feed; };
  switch (section) {
  case BlockSection::Approach:
    return own(settings.plunge_feed);
  case BlockSection::LeadIn:
  case BlockSection::LeadOut:
  case BlockSection::Retract:
    return own(settings.lead_feed);
  case BlockSection::Link:
    return own(settings.link_feed);
  default:
    return settings.feed;
  }
}

double
countedWay(double contact, double tool)
{
  return contact > 0.0 ? std::clamp(contact, tool / tool_way, tool * tool_way) : tool;
}

double
moveMinutes(const Kinematics& kinematics, const ProgramSettings& settings, const ProgramBlock& a, const ProgramBlock& b)
{
  const double at_feed = b.rapid ? 0.0 : wayOfBlock(a, b, settings.ball_radius) / feedOf(settings, b.section);
  return std::max(at_feed, axisTime(kinematics, a, b));
}

void
setBlockTimes(const Kinematics& kinematics, const ProgramSettings& settings, MachineProgram& program)
{
  ProgramReport& report = program.report;
  report.minutes = 0.0;
  report.slowed_blocks = report.tool_slowed_blocks = 0;
  report.least_feed_share = 1.0;
  for (std::size_t i = 1; i < program.blocks.size(); ++i) {
    const ProgramBlock& before = program.blocks[i - 1];
    ProgramBlock& block = program.blocks[i];
    if (block.rapid)
      continue;
    const double at_feed = wayOfBlock(before, block, settings.ball_radius) / feedOf(settings, block.section);
    const double needed = axisTime(kinematics, before, block);
    block.minutes = std::max(at_feed, needed);
    report.minutes += block.minutes;
    const double contact = block.arc_length - before.arc_length;
    if (block.section != BlockSection::Cut || !(block.minutes > contact / settings.feed * (1.0 + 1e-9)))
      continue;
    const bool by_axis = needed > at_feed * (1.0 + 1e-9);
    if (!by_axis && !(contact > 0.0))
      continue; // a contact that stands has no feed
    ++report.slowed_blocks;
    if (!by_axis)
      ++report.tool_slowed_blocks;
    else if (at_feed / needed < report.least_feed_share) {
      report.least_feed_share = at_feed / needed;
      report.least_feed_at = before.arc_length;
    }
  }
}

} // namespace pcl_spiral
