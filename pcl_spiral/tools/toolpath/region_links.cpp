// SPDX-License-Identifier: BSD-3-Clause
#include "region_links.h"

#include "path_program.h"

#include <algorithm>

using namespace pcl_spiral;

namespace {

/** The first and the last two poses of each pass: what decides how the tool comes and leaves. */
std::vector<ToolPoses>
passEnds(const Result& result)
{
  std::vector<ToolPoses> passes = ballPasses(*result.plan.path, result.plan.settings.tool_radius);
  for (ToolPoses& pass : passes)
    if (pass.size() > 4)
      pass.erase(pass.begin() + 2, pass.end() - 2);
  return passes;
}

} // namespace

RegionLinks
checkedLinks(const Job& job, Result& result)
{
  Diagnostics unused; // warnings about a machine that is not asked for
  const MachineProgram program = freeProgram(job, xyzacTrunnion(), passEnds(result), result, unused);
  return linksOf(result, program);
}

RegionLinks
linksOf(const Result& result, const MachineProgram& program)
{
  RegionLinks links{result.plan.regions.size() - 1, 0.0};
  bool begun = false;
  for (const ProgramBlock& block : program.blocks) {
    if (block.section != BlockSection::Position)
      continue;
    links.height = begun ? std::max(links.height, block.tip.z()) : block.tip.z();
    begun = true;
  }
  return links;
}
