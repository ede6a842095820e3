// SPDX-License-Identifier: BSD-3-Clause
#include "path_program.h"
#include "program/free_leads.h"
#include "program/machine_moves.h"

using namespace pcl_spiral;

void
addProgram(const Job& job, const Machine& machine, Result& result)
{
  constexpr double deviations = 5.0; // of the noise: no point is farther from the surface
  StageClock clock(result.report.stages);
  const SpiralSettings& s = job.settings;
  result.program =
      makeProgram(job.program, machine, s.feed, s.tool_radius, ballPasses(*result.path, s.tool_radius), result.report.warnings);
  LedTool tool;
  tool.cutter = CutterShape::ball(s.tool_radius);
  tool.tolerance = s.chord_error + deviations * result.report.noise;
  tool.threads = s.threads;
  requireFreeLeads(job.scan, result.whole_scan, tool, *result.program, job.program.accept_collisions, job.quiet, result.report.warnings);
  clock.end("machine");
}
