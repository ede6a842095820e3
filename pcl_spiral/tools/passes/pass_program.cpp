// SPDX-License-Identifier: BSD-3-Clause
#include "pass_program.h"

#include "program/machine_moves.h"

using namespace pcl_spiral;

namespace {

constexpr double usual_smoothing = 20.0; ///< mm: tried where axes are not smoothed

ProgramPlanner
plannerOf(const PassJob& job, const PassResult& result)
{
  ProgramPlanner planner;
  planner.setInputPlan(result);
  ProgramSettings settings = job.program.settings;
  settings.feed = job.feed;
  planner.setSettings(settings);
  return planner;
}

} // namespace

void
addProgram(const PassJob& job, const Machine& machine, PassResult& result)
{
  ProgramPlanner planner = plannerOf(job, result);
  result.program = plannedProgram(job.program, machine, job.part, job.quiet, planner, result.warnings);
  result.motion = studiedMotion(job.program, job.outputs, job.tolerance, *result.program);
  if (job.cutter.radius > 0.0)
    for (const Diagnostic& warning : spindleWarnings(job.program, machine, job.outputs))
      result.warnings.push_back(warning);
}

bool
changeFor(MotionChange change, const Machine& machine, PassJob& job)
{
  if (change == MotionChange::ChordError)
    job.tolerance *= 2.0;
  else if (change == MotionChange::LongerBlocks)
    leaveOutBlocks(job.tolerance, job.program.settings);
  else
    job.axis_smoothing = job.axis_smoothing > 0.0 ? 2.0 * job.axis_smoothing : usual_smoothing;
  return change != MotionChange::AxisSmoothing || !machine.three_axes;
}

void
addMoves(const PassJob& job, PassResult& result)
{
  ProgramPlanner planner = plannerOf(job, result);
  planner.setCheckLeads(!result.program); // those of a program are checked
  result.moves = plannedMoves(job.part, job.quiet, planner, result.warnings);
}
