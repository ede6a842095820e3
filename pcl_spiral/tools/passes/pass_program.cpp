// SPDX-License-Identifier: BSD-3-Clause
#include "pass_program.h"

#include "pass_check.h"
#include "program/exchange_files.h"
#include "program/free_leads.h"
#include "program/free_path.h"
#include "program/machine_moves.h"
#include "program/stay_down.h"

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/io/file_error.h>

#include <algorithm>
#include <cmath>

using namespace pcl_spiral;

namespace {

/** Refuses a program in which the beam nearly stops: it would burn the part. */
void
requireSteadyBeam(const PassJob& job, const MachineProgram& program)
{
  constexpr double least_share = 0.5; // share of the feed
  const ProgramReport& report = program.report;
  if (report.slowed_blocks == 0 || report.least_feed_share >= least_share)
    return;
  const auto slowest = std::min_element(program.blocks.begin(), program.blocks.end(), [&](const ProgramBlock& a, const ProgramBlock& b) {
    return std::abs(a.arc_length - report.least_feed_at) < std::abs(b.arc_length - report.least_feed_at);
  });
  throw FileError(job.part,
                  Diagnostic("at ", Place(slowest->tip), " the rotary axes turn so far that the beam moves at only ",
                             100.0 * report.least_feed_share,
                             " % of the feed while it is on, and would burn the part: tilt the beam "
                             "(--tilt 20), or turn the part on the machine, so that the tool axis stays away from the direction of ",
                             std::string(1, program.machine.rotary[0].letter)));
}

/** The tool of \p job, whose collisions may be accepted. */
PassSettings
toolOf(const PassJob& job)
{
  PassSettings tool = job;
  tool.accept_collisions = job.program.accept_collisions;
  return tool;
}

/** Shank and holder are clear of the scan on the cutting moves. */
void
requireFreeHolder(const PassJob& job, PassResult& result)
{
  if (isGiven(job, "no-gouge-check"))
    return;
  PathCheck asked;
  static_cast<ToolWay&>(asked) = wayOf(result, toolOf(job));
  asked.file = job.part;
  asked.quiet = job.quiet;
  requireFreePath(asked, *result.program, result.warnings);
}

/** The leads of a cutter are clear of the scan. */
void
requireFree(const PassJob& job, const MachineProgram& program, PassResult& result)
{
  if (!(job.cutter.radius > 0.0) || !result.whole)
    return;
  requireFreeLeads(job.part, result.whole, wayOf(result, toolOf(job)).tool, program, job.program.accept_collisions, job.quiet,
                   result.warnings);
}

} // namespace

void
addProgram(const PassJob& job, const Machine& machine, PassResult& result)
{
  Diagnostics warnings;
  const auto make = [&](const std::vector<std::size_t>& retracted) {
    warnings.clear();
    return makeProgram(job.program, machine, job.feed, isBall(job) ? job.cutter.radius : 0.0, result.passes, retracted, warnings);
  };
  result.program = linkedProgram(job.program, make, job.part, result.whole, wayOf(result, toolOf(job)).tool);
  result.warnings.insert(result.warnings.end(), warnings.begin(), warnings.end());
  if (job.cutter.radius > 0.0)
    for (const Diagnostic& warning : spindleWarnings(job.program, machine, job.outputs))
      result.warnings.push_back(warning);
  else
    requireSteadyBeam(job, *result.program);
  requireFree(job, *result.program, result);
  if (job.cutter.radius > 0.0 && result.whole)
    requireFreeHolder(job, result);
}

void
addMoves(const PassJob& job, PassResult& result)
{
  result.moves = exchangeMoves(job.program, job.feed, isBall(job) ? job.cutter.radius : 0.0, result.passes);
  if (!result.program)
    requireFree(job, programOf(result.moves), result);
}
