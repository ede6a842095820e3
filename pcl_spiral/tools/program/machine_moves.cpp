// SPDX-License-Identifier: BSD-3-Clause
#include "machine_moves.h"
#include "program_check.h"
#include "terminal/file_names.h"
#include "terminal/terminal.h"

#include "io/post/post_check.h"
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/machine_reader.h>
#include <pcl_spiral/io/motion_text.h>

#include <algorithm>
#include <cstdio>

using namespace pcl_spiral;

std::optional<Machine>
machineOf(const ProgramJob& program, const std::vector<std::string>& outputs)
{
  if (!hasProgram(program, outputs))
    return std::nullopt;
  const std::string& file = program.machine_file;
  const Machine machine = file.empty() ? xyzacTrunnion() : readMachine(file);
  for (const std::string& output : outputs)
    if (isProgram(output))
      if (const Diagnostic fault = faultOfSettings(languageOf(program, output), machine, program.header); !fault.empty())
        throw FileError(output, Diagnostic(fault, (file.empty() ? " (no --machine is given)" : " (machine file " + file + ")")));
  return machine;
}

namespace {

/** Runs \p planner for \p made. */
template <typename Made>
void
run(bool quiet, ProgramPlanner& planner, Made& made)
{
  ProgressBar bar(quiet);
  planner.setQuiet(true);
  planner.setProgressCallback([&bar](double share, const std::string& stage) { return bar.update(share, stage); });
  planner.compute(made);
  bar.clear();
}

/** Refuses what \p planner refused. \throw FileError about the machine's \p machine file, or about \p file; Cancelled */
void
requireMade(const std::string& machine, const std::string& file, const ProgramPlanner& planner)
{
  const Status& status = planner.getStatus();
  if (status.code() == StatusCode::Cancelled || cancelled())
    throw Cancelled();
  if (!status.ok())
    throw FileError(planner.isMachineFault() ? machine : file, status.diagnostic());
}

} // namespace

MachineProgram
plannedProgram(const ProgramJob& job, const Machine& machine, const std::string& file, bool quiet, ProgramPlanner& planner,
               Diagnostics& warnings)
{
  MachineProgram program;
  planner.setMachine(machine);
  run(quiet, planner, program);
  requireMade(job.machine_file.empty() ? machine.name : job.machine_file, file, planner);
  if (job.machine_file.empty())
    warnings.push_back(noMachineWarning());
  warnings.insert(warnings.end(), planner.getWarnings().begin(), planner.getWarnings().end());
  return program;
}

std::vector<ToolMoves>
plannedMoves(const std::string& file, bool quiet, ProgramPlanner& planner, Diagnostics& warnings)
{
  std::vector<ToolMoves> moves;
  run(quiet, planner, moves);
  requireMade(file, file, planner);
  warnings.insert(warnings.end(), planner.getWarnings().begin(), planner.getWarnings().end());
  return moves;
}

PassLinks
plannedLinks(const std::string& file, bool quiet, ProgramPlanner& planner, Diagnostics& warnings)
{
  PassLinks links;
  run(quiet, planner, links);
  requireMade(xyzacTrunnion().name, file, planner);
  warnings.insert(warnings.end(), planner.getWarnings().begin(), planner.getWarnings().end());
  return links;
}

Diagnostics
spindleWarnings(const ProgramJob& job, const Machine& machine, const std::vector<std::string>& outputs)
{
  Diagnostics warnings;
  for (const std::string& output : outputs)
    if (isProgram(output))
      for (const Diagnostic& warning : spindleWarnings(output, machine, job.header))
        warnings.push_back(warning);
  return warnings;
}

void
writeProgramFile(const ProgramJob& job, const MachineProgram& program, const ProgramTexts& texts, const std::string& output,
                 const std::string& file)
{
  writeProgram(file, program, languageOf(job, output), headerOf(job.header, texts, job.machine_file, job.smoothing));
}

MotionStudy
studiedMotion(const ProgramJob& job, const std::vector<std::string>& outputs, double chord_error, const MachineProgram& program)
{
  const auto first = std::find_if(outputs.begin(), outputs.end(), isProgram);
  const Dialect dialect = first == outputs.end() ? job.dialect : languageOf(job, *first);
  return studyMotion(program, controlModel(entryOf(dialect).control, program.machine), job.smoothing.value_or(chord_error));
}

void
leaveOutBlocks(double tolerance, ProgramSettings& settings)
{
  constexpr double axis_per_tip = 0.5; // radians a mm, as in BlockTolerance
  settings.thinning.tip = std::max(settings.thinning.tip, tolerance);
  settings.thinning.axis = std::max(settings.thinning.axis, axis_per_tip * tolerance);
}

void
printProgram(const MachineProgram& program, const MotionStudy& motion)
{
  const ProgramReport& report = program.report;
  std::printf("program         %s: %zu blocks, %zu added, %zu left out, %s at feed\n", program.machine.name.c_str(), program.blocks.size(),
              report.split_blocks, report.thinned_poses, durationText(60.0 * report.minutes).c_str());
  if (motion.status.ok())
    std::printf("on the control  %s\nwould gain most %s\n", motionText(motion).c_str(), gainText(motion).c_str());
  if (report.links + report.blocked_links > 0)
    std::printf("links           %zu near the surface, %zu not free: the tool retracts; %.3g m and %s saved\n", report.links,
                report.blocked_links, report.saved_way / 1000.0, durationText(60.0 * report.saved_minutes).c_str());
  if (program.machine.three_axes)
    return;
  const auto& [first, second] = program.machine.rotary;
  std::printf("rotary axes     %c %.1f to %.1f degrees, %.1f turns in total, ends at %.1f; %c %.2f to %.2f degrees\n", first.letter,
              report.lowest_first * in_degrees, report.highest_first * in_degrees, report.first_travel * in_degrees / 360.0,
              program.blocks.back().angles.first * in_degrees, second.letter, report.lowest_second * in_degrees,
              report.highest_second * in_degrees);
}
