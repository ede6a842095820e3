// SPDX-License-Identifier: BSD-3-Clause
#include "stay_down_links.h"

#include "block_times.h"

#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/machine/impl/block_spacing.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr double most_link_turn = 0.5 * full_turn;

/** The machine where \p block ends; off the surface the contact is the tip. */
MachineLocation
endOf(const ProgramBlock& block)
{
  return {{block.tip, block.axis, block.tip, block.normal}, block.angles, block.arc_length};
}

double
largestTurn(const ProgramBlock& a, const ProgramBlock& b)
{
  return std::max(std::abs(b.angles.first - a.angles.first), std::abs(b.angles.second - a.angles.second));
}

/** A way from pass to pass: from the end of the lead off a pass to where the lead to the next begins. */
struct PassLink {
  ProgramBlock from;                 ///< where it begins
  std::vector<ProgramBlock> blocks;  ///< its moves; empty: the tool must retract
  std::vector<ProgramBlock> instead; ///< the moves of the retract that it replaces
};

/** The link from the last pass in \p blocks, which ends with its retract, to the pass that begins with \p entry; there is none where
 *  addEntry says so. \p turning: blocks at the top between both */
PassLink
passLink(const Kinematics& kinematics, Branch branch, const ProgramSettings& settings, const std::vector<ProgramBlock>& blocks,
         const std::vector<ProgramBlock>& turning, const std::vector<ProgramBlock>& entry)
{
  const auto retracts = [](const ProgramBlock& block) { return block.section == BlockSection::Retract; };
  const auto leads = [](const ProgramBlock& block) { return block.section == BlockSection::LeadIn; };
  const auto lead_out = std::find_if_not(blocks.rbegin(), blocks.rend(), retracts);
  const auto lead_in = std::find_if(entry.begin(), entry.end(), leads);
  if (lead_out == blocks.rend() || lead_in == entry.begin() || lead_in == entry.end())
    return {};
  const ProgramBlock &from = *lead_out, &to = *(lead_in - 1);
  if ((to.tip - from.tip).norm() > settings.stay_down || largestTurn(from, to) > most_link_turn)
    return {};
  PassLink link;
  link.from = from;
  link.instead.assign(lead_out.base(), blocks.end());
  link.instead.insert(link.instead.end(), turning.begin(), turning.end());
  link.instead.insert(link.instead.end(), entry.begin(), lead_in);
  const MachineLocations way = splitBlocks(kinematics, branch, {endOf(from), endOf(to)}, settings.block);
  for (std::size_t i = 1; i < way.size(); ++i)
    link.blocks.push_back(blockTo(kinematics, way[i].pose.tip, way[i], BlockSection::Link, false));
  return link;
}

/** Way of the tip and time of moves. */
struct MoveCost {
  double way = 0.0, minutes = 0.0;
};

MoveCost
costOf(const Kinematics& kinematics, const ProgramSettings& settings, const ProgramBlock& from, const std::vector<ProgramBlock>& blocks)
{
  MoveCost cost;
  const ProgramBlock* before = &from;
  for (const ProgramBlock& block : blocks) {
    cost.way += (block.tip - before->tip).norm();
    cost.minutes += moveMinutes(kinematics, settings, *before, block);
    before = &block;
  }
  return cost;
}

} // namespace

std::size_t
addEntry(const Kinematics& kinematics, const ProgramSettings& settings, const ToolLeads& leads, const std::vector<ProgramBlock>& entry,
         bool may_link, MachineProgram& program)
{
  std::vector<ProgramBlock>& blocks = program.blocks;
  std::vector<ProgramBlock> turning;
  if (!blocks.empty())
    turning = leads.unwinding(blocks.back(), entry.front().angles.first);
  const auto add = [&blocks](auto begin, auto end) { blocks.insert(blocks.end(), begin, end); };
  const PassLink link = may_link ? passLink(kinematics, program.report.branch, settings, blocks, turning, entry) : PassLink();
  if (link.blocks.empty()) {
    const std::size_t first = blocks.size();
    add(turning.begin(), turning.end());
    add(entry.begin(), entry.end());
    return first;
  }
  while (blocks.back().section == BlockSection::Retract)
    blocks.pop_back();
  const std::size_t first = blocks.size();
  add(link.blocks.begin(), link.blocks.end());
  add(std::find_if(entry.begin(), entry.end(), [](const ProgramBlock& block) { return block.section == BlockSection::LeadIn; }),
      entry.end());
  ++program.report.links;
  const MoveCost replaced = costOf(kinematics, settings, link.from, link.instead),
                 own = costOf(kinematics, settings, link.from, link.blocks);
  program.report.saved_way += replaced.way - own.way;
  program.report.saved_minutes += replaced.minutes - own.minutes;
  return first;
}

} // namespace pcl_spiral
