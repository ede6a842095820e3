// From a scan to gouge-free locations of any cutter along a drive path: planes, helix, rings, curve, offsets.
#include "drive/command_line.h"
#include "drive/job_check.h"
#include "drive/outputs.h"
#include "drive/planning.h"
#include "program/free_leads.h"
#include "program/machine_moves.h"
#include "program/program_check.h"
#include "report/picture_files.h"
#include "terminal/setter_names.h"
#include "terminal/terminal.h"

#include <pcl_spiral/io/output_files.h>

#include <pcl/console/print.h>

#include <chrono>
#include <iostream>
#include <optional>

using namespace pcl_spiral;

namespace {

constexpr int failed_on_data = 1;
constexpr int bad_usage = 2;

void
run(const Job& job)
{
  const auto start = std::chrono::steady_clock::now();
  OutputFiles files(filesOf(job));
  for (const std::string& output : job.outputs)
    requireDisplay(output);
  if (!job.verbose)
    pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS); // what fails is said below, once
  const std::optional<Machine> machine =
      hasProgram(job.program, job.outputs) ? std::optional(machineOf(job.program)) : std::nullopt;
  Result result = plan(job);
  if (machine) {
    ProgramJob program = job.program;
    if (!isBall(job))
      program.settings.pole_cone = 0.0; // a blended axis would lead any other cutter into the surface
    result.program =
        makeProgram(program, *machine, job.feed, isBall(job) ? job.cutter.radius : 0.0, result.passes, result.warnings);
    requireFreeLeads(job.scan, result.whole_scan,
                     {job.cutter, job.holder, job.holder_clearance, job.tolerance + result.locations.noise_allowance,
                      job.threads},
                     *result.program, program.accept_collisions, job.quiet, result.warnings);
  }
  if (!job.quiet)
    for (const std::string& warning : result.warnings)
      std::cerr << "pcl_spiral_drive: warning: " << warning << '\n';
  writeOutputs(job, result, files);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  if (!job.quiet)
    printSummary(job, result, seconds.count());
}

} // namespace

int
main(int argc, char** argv)
{
  catchSignals();
  try {
    const Job job = parseCommandLine(argc, argv);
    if (job.help)
      printHelp(std::cout);
    else if (job.version)
      std::cout << "pcl_spiral_drive " PCL_SPIRAL_VERSION "\n";
    else
      run(job);
    return 0;
  }
  catch (const UsageError& error) {
    std::cerr << "pcl_spiral_drive: " << error.what() << "\npcl_spiral_drive --help lists the options\n";
    return bad_usage;
  }
  catch (const std::exception& error) {
    std::cerr << "pcl_spiral_drive: " << inOptions(error.what()) << '\n';
    return failed_on_data;
  }
}
