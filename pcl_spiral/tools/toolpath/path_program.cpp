// SPDX-License-Identifier: BSD-3-Clause
#include "path_program.h"
#include "holder_way.h"
#include "program/free_leads.h"
#include "program/machine_moves.h"
#include "region_links.h"

using namespace pcl_spiral;

MachineProgram
freeProgram(const Job& job, const Machine& machine, const std::vector<ToolPoses>& passes, Result& result, std::vector<std::string>& made)
{
  const SpiralSettings& s = job.settings;
  ProgramJob asked = job.program;
  asked.settings.clear_box = boxToClear(job, result);
  MachineProgram program = makeProgram(asked, machine, s.feed, s.tool_radius, passes, made);
  requireFreeLeads(job.scan, result.whole_scan, toolOf(job, result.report), program, job.program.accept_collisions, job.quiet,
                   result.report.warnings);
  return program;
}

void
addProgram(const Job& job, const Machine& machine, Result& result)
{
  StageClock clock(result.report.stages);
  std::vector<std::string> made = spindleWarnings(job.program, machine, job.outputs);
  result.program = freeProgram(job, machine, ballPasses(*result.path, job.settings.tool_radius), result, made);
  result.report.warnings.insert(result.report.warnings.end(), made.begin(), made.end());
  checkHolder(job, *result.program, result);
  if (!result.regions.empty())
    result.links = linksOf(result, *result.program);
  clock.end("machine");
}
