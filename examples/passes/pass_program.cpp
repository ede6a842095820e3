#include "pass_program.h"

#include "pass_check.h"
#include "program/free_leads.h"
#include "program/machine_moves.h"
#include "program/program_check.h"

using namespace pcl_spiral;

std::optional<Machine>
machineOf(const PassJob& job)
{
  return hasProgram(job.program, job.outputs) ? std::optional(machineOf(job.program)) : std::nullopt;
}

void
addProgram(const PassJob& job, const Machine& machine, PassResult& result)
{
  ProgramJob program = job.program;
  if (!isBall(job))
    program.settings.pole_cone = 0.0; // a blended axis would lead any other tool off its path
  result.program = makeProgram(program, machine, job.feed, isBall(job) ? job.cutter.radius : 0.0, result.passes, result.warnings);
  if (!(job.cutter.radius > 0.0) || !result.whole_scan)
    return;
  requireFreeLeads(job.scan, result.whole_scan,
                   {job.cutter, job.holder, job.holder_clearance, job.tolerance + result.locations.noise_allowance, job.threads},
                   *result.program, program.accept_collisions, job.quiet, result.warnings);
}
