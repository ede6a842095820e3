// SPDX-License-Identifier: BSD-3-Clause
#include "path_program.h"
#include "program/exchange_files.h"
#include "program/free_leads.h"
#include "program/free_path.h"
#include "program/machine_moves.h"
#include "program/stay_down.h"
#include "region_links.h"

using namespace pcl_spiral;

namespace {

/** With everything in the scan below the rapids. */
ProgramJob
programJob(const Job& job, const Result& result)
{
  ProgramJob asked = job.program;
  asked.settings.clear_box = result.plan.clearBox();
  return asked;
}

LedTool
toolOf(const Job& job, const SpiralPlan& plan)
{
  return toolOf(plan, job.flank_length, job.holder, job.holder_clearance);
}

/** Shank and holder are clear of everything on the cutting moves of \p program. */
void
requireFreeHolder(const Job& job, const MachineProgram& program, SpiralPlan& plan)
{
  if (job.holder.empty())
    return;
  PathCheck asked;
  static_cast<ToolWay&>(asked) = wayOf(plan, toolOf(job, plan));
  asked.accepted = job.program.accept_collisions;
  asked.file = job.scan;
  asked.quiet = job.quiet;
  requireFreePath(asked, program, plan.report.warnings);
}

/** The leads are clear of the scan. */
void
requireFree(const Job& job, const MachineProgram& program, Result& result)
{
  requireFreeLeads(job.scan, result.plan.whole, toolOf(job, result.plan), program, job.program.accept_collisions, job.quiet,
                   result.plan.report.warnings);
}

} // namespace

MachineProgram
freeProgram(const Job& job, const Machine& machine, const std::vector<ToolPoses>& passes, Result& result, Diagnostics& made)
{
  Diagnostics warnings;
  const ProgramJob asked = programJob(job, result);
  const auto make = [&](const std::vector<std::size_t>& retracted) {
    warnings.clear();
    return makeProgram(asked, machine, job.settings.feed, job.settings.tool_radius, passes, retracted, warnings);
  };
  MachineProgram program = linkedProgram(asked, make, job.scan, result.plan.whole, toolOf(job, result.plan));
  made.insert(made.end(), warnings.begin(), warnings.end());
  requireFree(job, program, result);
  return program;
}

void
addProgram(const Job& job, const Machine& machine, Result& result)
{
  StageClock clock(result.plan.report.stages);
  Diagnostics made = spindleWarnings(job.program, machine, job.outputs);
  result.program = freeProgram(job, machine, ballPasses(*result.plan.path, job.settings.tool_radius), result, made);
  result.plan.report.warnings.insert(result.plan.report.warnings.end(), made.begin(), made.end());
  requireFreeHolder(job, *result.program, result.plan);
  if (!result.plan.regions.empty())
    result.links = linksOf(result, *result.program);
  clock.end("machine");
}

void
addMoves(const Job& job, Result& result)
{
  StageClock clock(result.plan.report.stages);
  const std::vector<ToolPoses> passes = ballPasses(*result.plan.path, job.settings.tool_radius);
  result.moves = exchangeMoves(programJob(job, result), job.settings.feed, job.settings.tool_radius, passes);
  if (!result.program)
    requireFree(job, programOf(result.moves), result);
  clock.end("leads");
}
