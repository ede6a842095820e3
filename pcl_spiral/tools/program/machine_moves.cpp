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

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <regex>

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
    warnings.push_back("no --machine is given: the program is for LinuxCNC's xyzac-trt-kins with all offsets zero and both "
                       "rotary axes at up to 30 rev/min; no limits are checked");
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
  const std::regex starts("\\{spindle\\}|(^|[^A-Za-z])M0?[34]($|[^0-9])");
  const auto& header = machine.lines.header;
  Diagnostics warnings;
  if (job.header.spindle_speed > 0.0 ||
      std::any_of(header.begin(), header.end(), [&starts](const std::string& line) { return std::regex_search(line, starts); }))
    return warnings;
  for (const std::string& output : outputs)
    if (isProgram(output))
      warnings.push_back(Diagnostic(output,
                                    ": the spindle stands still: no --spindle is given, and no line of the machine file starts it; give "
                                    "--spindle 12000, or start it in program: {{header: [...]}} of the machine file"));
  return warnings;
}

void
writeProgramFile(const ProgramJob& job, const MachineProgram& program, const ProgramTexts& texts, const std::string& output,
                 const std::string& file)
{
  ProgramHeader header = job.header;
  header.title = texts.title;
  header.notes = texts.notes;
  if (!job.machine_file.empty())
    header.notes.push_back("machine file " + std::filesystem::path(job.machine_file).filename().string());
  header.smoothing = job.smoothing.value_or(texts.chord_error);
  writeProgram(file, program, languageOf(job, output), header);
}

void
printProgram(const MachineProgram& program)
{
  const ProgramReport& report = program.report;
  std::printf("program         %s: %zu blocks, %zu added, %zu left out, %s at feed\n", program.machine.name.c_str(), program.blocks.size(),
              report.split_blocks, report.thinned_poses, duration(60.0 * report.minutes).c_str());
  if (report.links + report.blocked_links > 0)
    std::printf("links           %zu near the surface, %zu not free: the tool retracts; %.3g m and %s saved\n", report.links,
                report.blocked_links, report.saved_way / 1000.0, duration(60.0 * report.saved_minutes).c_str());
  if (program.machine.three_axes)
    return;
  const auto& [first, second] = program.machine.rotary;
  std::printf("rotary axes     %c %.1f to %.1f degrees, %.1f turns in total, ends at %.1f; %c %.2f to %.2f degrees\n", first.letter,
              report.lowest_first * in_degrees, report.highest_first * in_degrees, report.first_travel * in_degrees / 360.0,
              program.blocks.back().angles.first * in_degrees, second.letter, report.lowest_second * in_degrees,
              report.highest_second * in_degrees);
}
