// SPDX-License-Identifier: BSD-3-Clause
// From a scan or a mesh to toolpath files: the main program.
#include "judging/figures_table.h"
#include "judging/judge.h"
#include "program/free_leads.h"
#include "program/machine_moves.h"
#include "program/program_check.h"
#include "terminal/program_main.h"
#include "terminal/setter_names.h"
#include "terminal/terminal.h"
#include "toolpath/command_line.h"
#include "toolpath/console.h"
#include "toolpath/job_check.h"
#include "toolpath/outputs.h"
#include "toolpath/planning.h"

#include "io/output_files.h"
#include <pcl_spiral/io/file_error.h>

#include <pcl/console/print.h>

#include <chrono>
#include <iostream>
#include <optional>

using namespace pcl_spiral;

namespace {

void
warn(const Job& job, const std::vector<std::string>& warnings)
{
  if (!job.quiet)
    for (const std::string& warning : warnings)
      std::cerr << "pcl_spiral_toolpath: warning: " << warning << '\n';
}

void
verify(const Job& job, Result& result)
{
  ProgressBar bar(job.quiet);
  const SpiralSettings& s = job.settings;
  JudgeSettings settings;
  settings.tool_radius = s.tool_radius;
  settings.scallop_height = s.scallop_height;
  settings.chord_error = s.chord_error;
  settings.view_point = s.view_point;
  settings.flip_normals = s.flip_normals;
  settings.threads = s.threads;
  settings.sample_spacing = job.sample_spacing;
  if (result.mesh)
    settings.mesh = result.mesh->mesh;
  else
    settings.surface = result.surface;
  std::shared_ptr<const ReferenceSurface> reference;
  Verification verification;
  const Status status = judgePath(
      result.scan.cloud, result.path, settings, [&bar](double share, const std::string& stage) { return bar.update(share, stage); },
      reference, verification, result.heights);
  bar.clear();
  if (cancelled())
    throw Cancelled();
  if (!status.ok())
    throw FileError(job.scan, "the path was made but could not be judged: " + inOptions(status.message()));
  if (!settings.surface)
    result.report.passes += reference->scanned().counts().passes;
  result.verification = std::move(verification);
}

void
layOnMachine(const Job& job, const Machine& machine, Result& result)
{
  constexpr double deviations = 5.0; // of the noise: no point stands further off the surface
  StageClock clock(result.report.stages);
  const SpiralSettings& s = job.settings;
  result.program =
      makeProgram(job.program, machine, s.feed, s.tool_radius, ballPasses(*result.path, s.tool_radius), result.report.warnings);
  LedTool tool;
  tool.cutter = CutterShape::ball(s.tool_radius);
  tool.tolerance = s.chord_error + deviations * result.report.noise;
  tool.threads = s.threads;
  requireFreeLeads(job.scan, result.scan.cloud, tool, *result.program, job.program.accept_collisions, job.quiet, result.report.warnings);
  clock.end("machine");
}

void
run(const Job& job)
{
  const auto start = std::chrono::steady_clock::now();
  checkJob(job);
  OutputFiles files(filesOf(job));
  for (const std::string& output : job.outputs)
    requireDisplay(output);
  if (!job.verbose)
    pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS); // what fails is said below, once
  const std::optional<Machine> machine = hasProgram(job.program, job.outputs) ? std::optional(machineOf(job.program)) : std::nullopt;
  Result result = computePath(job);
  if (machine)
    layOnMachine(job, *machine, result);
  if (job.verify)
    verify(job, result);
  warn(job, result.scan.warnings);
  warn(job, result.report.warnings);
  if (result.verification)
    warn(job, warningsOf(*result.verification));
  writeOutputs(job, result, files);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  if (!job.quiet)
    printSummary(job, result, seconds.count());
  if (!job.quiet && result.verification)
    printFigures(*result.verification);
}

} // namespace

int
main(int argc, char** argv)
{
  return runProgram("pcl_spiral_toolpath", [&] {
    const Job job = parseCommandLine(argc, argv);
    if (job.help)
      printHelp(std::cout);
    else if (job.version)
      std::cout << "pcl_spiral_toolpath " PCL_SPIRAL_VERSION "\n";
    else
      run(job);
    return 0;
  });
}
