// SPDX-License-Identifier: BSD-3-Clause
#include "verify/blocked_links.h"

namespace pcl_spiral {
namespace {

/** The links alone, the tip lower by \p depth. A link starts with the end of the block before it, to which there is no move. */
MachineProgram
linksOf(const MachineProgram& program, double depth, std::vector<std::size_t>& passes)
{
  MachineProgram links;
  links.machine = program.machine;
  const auto add = [&](const ProgramBlock& block, BlockSection section) {
    ProgramBlock lower = block;
    lower.section = section;
    lower.tip -= depth * block.axis;
    links.blocks.push_back(lower);
    passes.push_back(block.pass);
  };
  for (std::size_t i = 1; i < program.blocks.size(); ++i) {
    if (program.blocks[i].section != BlockSection::Link)
      continue;
    if (program.blocks[i - 1].section != BlockSection::Link)
      add(program.blocks[i - 1], BlockSection::Cut);
    add(program.blocks[i], BlockSection::Link);
  }
  return links;
}

} // namespace

Status
findBlockedLinks(LeadCheck<pcl::PointXYZ> check, const MachineProgram& program, double room, std::vector<std::size_t>& passes)
{
  passes.clear();
  // A cutter larger by more than its tolerance, all round: what is in it is nearer than the room.
  const double larger = room + check.getTolerance();
  std::vector<std::size_t> pass_of_block;
  const MachineProgram links = linksOf(program, larger, pass_of_block);
  if (links.blocks.empty())
    return Status::success();
  check.setCutter(insetCutter(CutterProfile(check.getCutter()), -larger).shape());
  check.setHolderClearance(check.getHolderClearance() + room);
  check.setLargestEcho(0);
  check.compute(links);
  for (const std::size_t block : check.getReport().blocks)
    if (passes.empty() || passes.back() != pass_of_block[block])
      passes.push_back(pass_of_block[block]);
  return check.getStatus();
}

} // namespace pcl_spiral
