// SPDX-License-Identifier: BSD-3-Clause
// From a scan to gouge-free locations of any cutter along a drive path: planes, helix, rings, curve, offsets.
#include "drive/command_line.h"
#include "drive/job_check.h"
#include "drive/outputs.h"
#include "drive/planning.h"
#include "passes/pass_program.h"
#include "report/picture_files.h"
#include "terminal/program_main.h"

#include "io/output_files.h"

#include <pcl/console/print.h>

#include <chrono>
#include <iostream>
#include <optional>

using namespace pcl_spiral;

namespace {

void
run(const Job& job)
{
  const auto start = std::chrono::steady_clock::now();
  OutputFiles files(filesOf(job));
  for (const std::string& output : job.outputs)
    requireDisplay(output);
  if (!job.verbose)
    pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS); // what fails is said below, once
  const std::optional<Machine> machine = machineOf(job);
  Result result = plan(job);
  if (machine)
    addProgram(job, *machine, result);
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
  return runProgram("pcl_spiral_drive", [&] {
    const Job job = parseCommandLine(argc, argv);
    if (job.help)
      printHelp(std::cout);
    else if (job.version)
      std::cout << "pcl_spiral_drive " PCL_SPIRAL_VERSION "\n";
    else
      run(job);
    return 0;
  });
}
