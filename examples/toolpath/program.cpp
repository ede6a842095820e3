#include "program.h"
#include "terminal/file_names.h"
#include "terminal/terminal.h"

#include <pcl_spiral/common/message.h>
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/machine_reader.h>
#include <pcl_spiral/io/path_exchange.h>
#include <pcl_spiral/io/setting_names.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

using namespace pcl_spiral;

namespace {

constexpr double degrees = 180.0 / 3.14159265358979323846;

std::string
titleOf(const Job& job)
{
  return std::filesystem::path(job.scan).filename().string();
}

void
require(bool holds, const std::string& option, double value, const std::string& rule)
{
  if (!holds)
    throw UsageError("--" + option + " " + textOf(value) + ": " + rule);
}

/** What a user should know before the program runs. */
std::vector<std::string>
warningsOf(const MachineProgram& program)
{
  const ProgramReport& report = program.report;
  const char first = program.machine.rotary[0].letter;
  std::vector<std::string> warnings;
  for (const PoleZone& zone : report.poles)
    warnings.push_back(textOf(
        "near the pole ", first, " would turn beyond its rate: the tool axis was blended from ", zone.begin,
        " to ", zone.end, " mm of the path, by up to ", zone.largest_change * degrees, " degrees"));
  if (report.slowed_blocks > 0)
    warnings.push_back(textOf(report.slowed_blocks, " of ", report.cut_blocks,
                              " blocks run below the feed for an axis to keep its rate, the slowest at ",
                              100.0 * report.least_feed_share, " % of it, at ", report.least_feed_at,
                              " mm of the path"));
  if (!report.unwound_at.empty())
    warnings.push_back(textOf("the tool leaves the surface ", report.unwound_at.size(), " times for ", first,
                              " to unwind at its limit, first at ", report.unwound_at.front(),
                              " mm of the path"));
  return warnings;
}

} // namespace

bool
isProgram(const std::string& output)
{
  const std::string extension = extensionOf(output);
  return extension == ".ngc" || extension == ".nc";
}

bool
isExchange(const std::string& output)
{
  const std::string extension = extensionOf(output);
  return extension == ".apt" || extension == ".cls" || extension == ".yaml";
}

bool
hasProgram(const Job& job)
{
  return !job.program.machine_file.empty() || std::any_of(job.outputs.begin(), job.outputs.end(), isProgram);
}

void
checkProgram(const Job& job)
{
  const ProgramSettings& s = job.program.settings;
  for (const std::string& output : job.outputs) {
    if (!isProgram(output))
      continue;
    if (extensionOf(output) == ".nc" && job.program.machine_file.empty())
      throw UsageError("-o " + output +
                       ": no --machine is given; name the machine's file, such as --machine xyzac.yaml "
                       "(some are in examples/machines, installed in share/pcl_spiral)");
    if (extensionOf(output) == ".nc" && job.given.count("dialect") == 0)
      throw UsageError("-o " + output + ": no --dialect is given; it must be one of " +
                       choiceList<Dialect>());
    if (extensionOf(output) == ".nc" && job.program.header.tool == 0)
      throw UsageError("-o " + output + ": no --tool is given; the control takes the tool's length by its number: "
                                        "--tool 3");
  }
  const bool other_language = job.given.count("dialect") > 0 && job.program.dialect != Dialect::LinuxCNC;
  if (other_language && std::none_of(job.outputs.begin(), job.outputs.end(),
                                     [](const std::string& output) { return extensionOf(output) == ".nc"; }))
    throw UsageError("--dialect " + choiceName(job.program.dialect) +
                     ": no output is in that language; write a .nc (a .ngc is LinuxCNC's)");
  require(s.lead_length > 0.0, "lead-length", s.lead_length, "must be above 0 mm");
  require(s.clearance > 0.0, "clearance", s.clearance, "must be above 0 mm");
  require(s.rapid_height > 0.0, "rapid-height", s.rapid_height, "must be above 0 mm");
  require(s.pole_cone >= 0.0 && s.pole_cone < 90.0, "pole-cone", s.pole_cone,
          "must lie between 0 and 90 degrees");
  require(s.block.tip >= BlockTolerance::least_tip, "block-tolerance", s.block.tip, "must be 0.0001 mm or more");
  require(s.block.axis >= BlockTolerance::least_axis, "block-tolerance", s.block.axis * degrees,
          "must be 0.00006 degrees or more");
  require(s.thinning.tip >= 0.0, "thin-blocks", s.thinning.tip, "must not be below 0 mm");
  require(s.thinning.axis >= 0.0, "thin-blocks", s.thinning.axis * degrees, "must not be below 0 degrees");
  const ProgramHeader& header = job.program.header;
  require(header.spindle_speed >= 0.0, "spindle", header.spindle_speed, "must be above 0 rev/min");
  require(header.tool >= 0, "tool", header.tool, "must be above 0");
  require(header.decimals >= 3 && header.decimals <= 6, "decimals", header.decimals, "must be 3 to 6");
}

Machine
machineOf(const Job& job)
{
  if (job.program.machine_file.empty())
    return xyzacTrunnion();
  Machine machine = readMachine(job.program.machine_file);
  const Dialect dialect = job.program.dialect;
  const bool tips =
      dialect == Dialect::FanucVectors || dialect == Dialect::Siemens || dialect == Dialect::Heidenhain;
  if (!machine.rtcp && tips)
    throw FileError(job.program.machine_file,
                    "rtcp: false, and --dialect " + choiceName(dialect) +
                        " takes tips and tool axes; use linuxcnc or fanuc, or rtcp: true");
  return machine;
}

void
makeProgram(const Job& job, const Machine& machine, Result& result)
{
  MachineProgramGenerator generator;
  generator.setMachine(machine);
  ProgramSettings settings = job.program.settings;
  settings.feed = job.settings.feed;
  generator.setSettings(settings);
  generator.setInputPath(*result.path, job.settings.tool_radius);
  MachineProgram program;
  generator.compute(program);
  if (!generator.getStatus().ok())
    throw FileError(job.program.machine_file.empty() ? machine.name : job.program.machine_file,
                    generator.getStatus().message());
  if (job.program.machine_file.empty())
    result.report.warnings.push_back(
        "no --machine is given: the program is for LinuxCNC's xyzac-trt-kins with nothing off zero, both "
        "rotary axes at up to 30 rev/min, and no limits are checked");
  if (!machine.retract_z)
    result.report.warnings.push_back(
        machine.name + ": no retract_z is given, the Z of the machine that is clear of everything: the program turns the "
        "rotary axes, and goes to its first point, from where the tool stands; start it above the part");
  for (const std::string& warning : warningsOf(program))
    result.report.warnings.push_back(warning);
  result.program = std::move(program);
}

void
writeMoves(const Job& job, const Result& result, const std::string& output, const std::string& file)
{
  const std::string extension = extensionOf(output);
  ProgramHeader header = job.program.header;
  header.title = titleOf(job);
  if (extension == ".yaml")
    return writeRobotFrames(file, *result.path);
  if (isProgram(output))
    return writeProgram(file, *result.program, extension == ".ngc" ? Dialect::LinuxCNC : job.program.dialect,
                        header);
  MachineProgramGenerator poses;
  poses.setInputPath(*result.path, job.settings.tool_radius);
  writeAPT(file, poses.getInputPoses(),
           {header.title, ballCutter(job.settings.tool_radius), header.spindle_speed, job.settings.feed});
}

void
printProgram(const MachineProgram& program)
{
  const ProgramReport& report = program.report;
  const auto& [first, second] = program.machine.rotary;
  std::printf("program         %s: %zu blocks, %zu put in, %zu left out, %s of feed\n",
              program.machine.name.c_str(), program.blocks.size(), report.split_blocks, report.thinned_poses,
              duration(60.0 * report.minutes).c_str());
  std::printf("rotary axes     %c %.1f to %.1f degrees, %.1f turns in all; %c %.2f to %.2f degrees\n",
              first.letter, report.lowest_first * degrees, report.highest_first * degrees,
              report.first_travel * degrees / 360.0, second.letter, report.lowest_second * degrees,
              report.highest_second * degrees);
}
