// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  main of the programs that make paths for a machine.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>

#include "machine_moves.h"
#include "program_check.h"
#include "report/picture_files.h"
#include "terminal/program_main.h"
#include "terminal/vocabulary.h"

#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/motion_text.h>
#include <pcl_spiral/io/output_files.h>

#include <pcl/console/print.h>

#include <chrono>
#include <iostream>
#include <optional>
#include <string>

/** Plans \p job again with each change that needs another program, with the program's own changeFor, and adds what it gains to the
 *  \p result. A change that gives no program gains nothing that is known. \throw Cancelled */
template <typename Job, typename Result>
void
addPlannedGains(const std::string& name, const Job& job, const pcl_spiral::Machine& machine, Result& result)
{
  using pcl_spiral::MotionChange;
  for (const MotionChange change : {MotionChange::ChordError, MotionChange::AxisSmoothing, MotionChange::LongerBlocks}) {
    Job changed = job;
    if (!changeFor(change, machine, changed))
      continue;
    try {
      Result again = change == MotionChange::LongerBlocks ? result : plan(changed);
      addProgram(changed, machine, again);
      if (again.motion->status.ok())
        addGain(change, again.motion->time.seconds, *result.motion);
    }
    catch (const pcl_spiral::FileError& error) {
      if (!job.quiet)
        std::cerr << name << ": warning: what " << wordsOf(change) << " would gain is not known: " << error.what() << '\n';
    }
  }
}

/** Turns a job into files with the program's own filesOf, plan, addProgram, changeFor, addMoves, judge, warningsOf, writeOutputs and
 *  printSummary, found by the type of its job. */
template <typename Job>
void
runMachining(const std::string& name, const Job& job)
{
  const auto start = std::chrono::steady_clock::now();
  pcl_spiral::OutputFiles files(filesOf(job));
  for (const std::string& file : filesOf(job))
    requireDisplay(file);
  if (!job.verbose)
    pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS); // errors are reported below, once
  const std::optional<pcl_spiral::Machine> machine = machineOf(job.program, job.outputs);
  auto result = plan(job);
  if (machine)
    addProgram(job, *machine, result);
  if (machine && job.program.gains && result.motion->status.ok())
    addPlannedGains(name, job, *machine, result);
  if (hasExchange(job.outputs))
    addMoves(job, result);
  judge(job, result);
  if (!job.quiet)
    for (const pcl_spiral::Diagnostic& warning : warningsOf(result))
      std::cerr << name << ": warning: " << inWords(warning) << '\n';
  writeOutputs(job, result, files);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  if (!job.quiet)
    printSummary(job, result, seconds.count());
}

/** main of the program \p name, with its own \p parse and \p help. */
template <typename Job>
int
machiningMain(const std::string& name, int argc, char* const* argv, Job (*parse)(int, const char* const*), void (*help)(std::ostream&))
{
  return runProgram(name, argv, [&] {
    const Job job = parse(argc, argv);
    if (job.help)
      help(std::cout);
    else if (job.version)
      std::cout << name << " " PCL_SPIRAL_VERSION "\n";
    else
      runMachining(name, job);
    return 0;
  });
}
