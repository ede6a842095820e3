// SPDX-License-Identifier: BSD-3-Clause
#include "exchange_files.h"
#include "terminal/file_names.h"
#include "terminal/scan_places.h"

#include <pcl_spiral/core/diagnostic.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace pcl_spiral;

void
printFrames(const ProgramJob& job, const std::vector<ToolMoves>& moves, const std::vector<std::string>& outputs)
{
  if (std::none_of(outputs.begin(), outputs.end(), [](const std::string& output) { return extensionOf(output) == ".yaml"; }))
    return;
  const FrameTurn turn = largestFrameTurn(moves, job.robot_z);
  if (turn.angle < 1e-6) {
    std::printf("robot frames    x does not turn from one waypoint to the next\n");
    return;
  }
  std::printf("robot frames    x turns by at most %.3g degrees from one waypoint to the next, tip at %s\n", turn.angle * 180.0 / M_PI,
              placeText(inScan(turn.place)).c_str());
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
