// SPDX-License-Identifier: BSD-3-Clause
#include "block_times.h"

#include <pcl_spiral/machine/impl/kinematics.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

/** The time the slowest axis needs from \p a to \p b. */
double
axisTime(const Machine& machine, const ProgramBlock& a, const ProgramBlock& b)
{
  double minutes = std::max(std::abs(b.angles.first - a.angles.first) / machine.rotary[0].range.largest_rate,
                            std::abs(b.angles.second - a.angles.second) / machine.rotary[1].range.largest_rate);
  for (int i = 0; i < 3; ++i)
    minutes = std::max(minutes, std::abs(b.machine[i] - a.machine[i]) / machine.linear[i].largest_rate);
  return minutes;
}

} // namespace

void
setBlockTimes(const Kinematics& kinematics, double feed, MachineProgram& program)
{
  ProgramReport& report = program.report;
  for (std::size_t i = 1; i < program.blocks.size(); ++i) {
    const ProgramBlock& before = program.blocks[i - 1];
    ProgramBlock& block = program.blocks[i];
    if (block.rapid)
      continue;
    const double contact = block.arc_length - before.arc_length;
    const double way = contact > 0.0 ? contact : (block.tip - before.tip).norm();
    const double needed = axisTime(kinematics.machine(), before, block);
    block.minutes = std::max(way / feed, needed);
    report.minutes += block.minutes;
    if (block.section != BlockSection::Cut || !(needed > way / feed * (1.0 + 1e-9)))
      continue;
    ++report.slowed_blocks;
    if (way / feed / needed < report.least_feed_share) {
      report.least_feed_share = way / feed / needed;
      report.least_feed_at = before.arc_length;
    }
  }
}

} // namespace pcl_spiral
