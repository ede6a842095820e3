// SPDX-License-Identifier: BSD-3-Clause
#include "path_program.h"
#include "program/machine_moves.h"

#include <algorithm>

using namespace pcl_spiral;

namespace {

ProgramPlanner
plannerOf(const Job& job, const SpiralPlan& plan)
{
  ProgramPlanner planner;
  planner.setInputPlan(plan);
  planner.setSettings(job.program.settings);
  return planner;
}

} // namespace

void
addProgram(const Job& job, const Machine& machine, Result& result)
{
  StageClock clock(result.plan.report.stages);
  Diagnostics& warnings = result.plan.report.warnings;
  for (const Diagnostic& warning : spindleWarnings(job.program, machine, job.outputs))
    warnings.push_back(warning);
  ProgramPlanner planner = plannerOf(job, result.plan);
  result.program = plannedProgram(job.program, machine, job.scan, job.quiet, planner, warnings);
  result.motion = studiedMotion(job.program, job.outputs, job.settings.chord_error, *result.program);
  if (!result.plan.regions.empty())
    result.links = linksOf(*result.program);
  clock.end("machine");
}

bool
changeFor(MotionChange change, const Machine& machine, Job& job)
{
  if (change == MotionChange::ChordError)
    job.settings.chord_error *= 2.0;
  else if (change == MotionChange::LongerBlocks)
    leaveOutBlocks(job.settings.chord_error, job.program.settings);
  else
    job.settings.axis_smoothing = std::max(2.0 * job.settings.axis_smoothing, SpiralSettings().axis_smoothing);
  return change != MotionChange::AxisSmoothing || !(machine.three_axes || job.settings.fixed_axis);
}

void
addMoves(const Job& job, Result& result)
{
  StageClock clock(result.plan.report.stages);
  ProgramPlanner planner = plannerOf(job, result.plan);
  planner.setCheckLeads(!result.program); // those of a program are checked
  result.moves = plannedMoves(job.scan, job.quiet, planner, result.plan.report.warnings);
  clock.end("leads");
}

void
checkLinks(const Job& job, Result& result)
{
  ProgramPlanner planner = plannerOf(job, result.plan);
  result.links = plannedLinks(job.scan, job.quiet, planner, result.plan.report.warnings);
}
