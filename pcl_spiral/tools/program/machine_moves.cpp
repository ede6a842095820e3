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

namespace {

constexpr double least_named = 0.001; // degrees that an axis is blended by: at the pole an upright tool keeps it

/** Adds the warnings about the program. */
Diagnostics
warningsOf(const MachineProgram& program)
{
  const ProgramReport& report = program.report;
  const char first = program.machine.rotary[0].letter;
  Diagnostics warnings;
  if (!report.poles.empty()) {
    const auto less = [](const PoleZone& a, const PoleZone& b) { return a.largest_change < b.largest_change; };
    const PoleZone& most = *std::max_element(report.poles.begin(), report.poles.end(), less);
    const Diagnostic where = report.poles.size() == 1 ? Diagnostic("from ") : Diagnostic("in ", report.poles.size(), " places, most from ");
    const double degrees = most.largest_change * in_degrees;
    warnings.push_back(Diagnostic("near the pole, ", first, " would turn faster than its limit: the tool axis was blended ", where,
                                  most.begin, " to ", most.end, " mm of the path, ",
                                  degrees < least_named ? Diagnostic("by less than ", least_named) : Diagnostic("by up to ", degrees),
                                  " degrees"));
  }
  if (const std::size_t by_axis = report.slowed_blocks - report.tool_slowed_blocks; by_axis > 0)
    warnings.push_back(Diagnostic(by_axis, " of ", report.cut_blocks, by_axis == 1 ? " blocks runs below" : " blocks run below",
                                  " the feed because of the rate limit of an axis, the slowest at ", 100.0 * report.least_feed_share,
                                  " % of it, at ", report.least_feed_at, " mm of the path"));
  if (report.tool_slowed_blocks > 0)
    warnings.push_back(Diagnostic(report.tool_slowed_blocks, " of ", report.cut_blocks,
                                  report.tool_slowed_blocks == 1 ? " blocks runs below" : " blocks run below",
                                  " the feed because the tool moves more than twice as far as its contact; it keeps to twice "
                                  "the feed"));
  if (!report.unwound_at.empty())
    warnings.push_back(Diagnostic("the tool leaves the surface ", report.unwound_at.size(), " times so that ", first,
                                  " can unwind at its limit, first at ", report.unwound_at.front(), " mm of the path"));
  return warnings;
}

} // namespace

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

MachineProgram
makeProgram(const ProgramJob& job, const Machine& machine, double feed, double ball_radius, const std::vector<ToolPoses>& passes,
            const std::vector<std::size_t>& retracted, Diagnostics& warnings)
{
  MachineProgramGenerator generator;
  generator.setMachine(machine);
  ProgramSettings settings = job.settings;
  settings.feed = feed;
  settings.ball_radius = ball_radius;
  generator.setSettings(settings);
  generator.setInputPasses(passes);
  generator.setRetractedPasses(retracted);
  MachineProgram program;
  generator.compute(program);
  if (!generator.getStatus().ok())
    throw FileError(job.machine_file.empty() ? machine.name : job.machine_file, generator.getStatus().diagnostic());
  if (job.machine_file.empty())
    warnings.push_back("no --machine is given: the program is for LinuxCNC's xyzac-trt-kins with all offsets zero and both "
                       "rotary axes at up to 30 rev/min; no limits are checked");
  if (!machine.retract_z)
    warnings.push_back(Diagnostic(machine.name,
                                  ": no retract_z is given (a machine Z that is clear of everything): the program turns the rotary axes "
                                  "and goes to its first point from the tool's present position; start it above the part"));
  for (const Diagnostic& warning : warningsOf(program))
    warnings.push_back(warning);
  return program;
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
