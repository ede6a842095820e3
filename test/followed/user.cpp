// SPDX-License-Identifier: BSD-3-Clause
#include "user.h"

#include "named_changes.h"
#include "raw_points.h"

#include "command_line/run_program.h"

#include <algorithm>
#include <chrono>
#include <set>
#include <sstream>

namespace pcl_spiral::followed {
namespace {

constexpr std::size_t most_commands = 3; // after the refusal

void
writeFiles(const RefusedInput& input, const ScratchFolder& folder)
{
  std::ostringstream text;
  text.precision(9);
  if (!input.sensor.isZero(0.0))
    text << "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " << input.points.size() << "\nHEIGHT 1\nVIEWPOINT "
         << input.sensor.transpose() << " 1 0 0 0\nPOINTS " << input.points.size() << "\nDATA ascii\n";
  for (const Eigen::Vector3d& p : input.points)
    text << p.transpose() << '\n';
  writeText(folder.path(input.scanName()), text.str());
  for (const auto& [name, content] : input.files)
    writeText(folder.path(name), content);
}

std::string
lineOf(const Command& command)
{
  std::string line;
  for (const std::string& word : command)
    line += (line.empty() ? "" : " ") + word;
  return line;
}

RunResult
run(const RefusedInput& input, const Command& command, const std::string& program, const ScratchFolder& folder, Followed& done)
{
  Command arguments{input.scanName(), "-o", "path.csv"};
  arguments.insert(arguments.end(), command.begin(), command.end());
  const auto begin = std::chrono::steady_clock::now();
  RunResult result = endOf(startProgram(program, arguments, folder), folder);
  done.seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  done.story.push_back("$ " + lineOf(command));
  if (result.code != 0)
    done.story.push_back("  " + result.err);
  return result;
}

double
radiusOf(const Command& command)
{
  return std::stod(*(std::find(command.begin(), command.end(), "--tool-radius") + 1));
}

/** The end of a path. */
End
judged(const RefusedInput& input, const Command& command, const ScratchFolder& folder, Followed& done)
{
  if (done.commands == 0)
    return End::PathAtOnce; // and so nothing is known of remedies
  const std::string fault = faultOfPath(input, radiusOf(command), folder.path("path.csv"));
  if (fault.empty())
    return End::Right;
  done.story.push_back("  " + fault);
  return End::Wrong;
}

} // namespace

Followed
follow(const RefusedInput& input, const std::string& program, const ScratchFolder& folder)
{
  writeFiles(input, folder);
  std::ostringstream radius, scallop;
  radius << input.radius;
  scallop << input.scallop;
  Command command{"--tool-radius", radius.str(), "--scallop", scallop.str()};
  command.insert(command.end(), input.arguments.begin(), input.arguments.end());
  Followed done;
  std::set<Command> before;
  for (;; ++done.commands) {
    before.insert(command);
    const RunResult result = run(input, command, program, folder, done);
    if (result.code == 0) {
      done.end = judged(input, command, folder, done);
      return done;
    }
    if (done.commands == 0)
      done.planner_named = plannerTried(result.err);
    if (onlyAnotherScan(result.err)) {
      done.end = End::Reported;
      return done;
    }
    const std::vector<Command> changes = namedChanges(input, command, result.err, folder);
    const auto next = std::find_if(changes.begin(), changes.end(), [&](const Command& change) { return before.count(change) == 0; });
    if (next == changes.end() || done.commands == most_commands) {
      done.end = next == changes.end() && !changes.empty() ? End::Loop : End::DeadEnd;
      return done;
    }
    command = *next;
  }
}

} // namespace pcl_spiral::followed
