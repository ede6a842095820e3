// SPDX-License-Identifier: BSD-3-Clause
#include "exchange_files.h"
#include "terminal/file_names.h"

using namespace pcl_spiral;

std::vector<ToolMoves>
exchangeMoves(const ProgramJob& job, double feed, double ball_radius, const std::vector<ToolPoses>& passes)
{
  ProgramSettings settings = job.settings;
  settings.feed = feed;
  settings.ball_radius = ball_radius;
  return ledPasses(passes, settings);
}

void
writeExchange(const ProgramJob& job, const ExchangePath& path, const std::optional<MachineProgram>& program, const std::string& output,
              const std::string& file)
{
  if (extensionOf(output) == ".yaml")
    return writeRobotFrames(file, path.moves, job.robot_z);
  writeAPT(file, program ? std::vector<ToolMoves>{movesOf(*program)} : path.moves,
           {path.title, path.cutter, job.header.spindle_speed, job.header.spindle_direction, job.header.coolant, job.header.tool});
}
