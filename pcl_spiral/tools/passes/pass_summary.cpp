// SPDX-License-Identifier: BSD-3-Clause
#include "pass_summary.h"

#include "program/exchange_files.h"
#include "program/machine_moves.h"
#include "terminal/scan_places.h"
#include "terminal/terminal.h"

#include <pcl_spiral/io/motion_text.h>

#include <cstdio>

using namespace pcl_spiral;

void
printPasses(const PassJob& job, const PassResult& result, const std::vector<std::string>& files, double seconds)
{
  if (job.cutter.radius > 0.0)
    std::printf("locations       %zu, %zu of them added between others; largest error of a move %.3g mm\n", result.poseCount(),
                result.bisection.inserted, result.bisection.largest_error);
  const LocationReport& f = result.locations;
  if (f.retilted > 0)
    std::printf("axis            turned at %zu locations, by up to %.3g degrees\n", f.retilted, f.largest_retilt);
  if (f.collisions > 0)
    std::printf("collisions      shank or holder at %zu locations, up to %.4g mm deep\n", f.collisions, f.deepest_collision);
  std::printf("path length     %.3f m of the tip\n", result.length / 1000.0);
  if (result.program)
    printProgram(*result.program, *result.motion);
  printFrames(job.program, result.moves, job.outputs);
  std::printf("time            %s\n", durationText(seconds).c_str());
  if (job.verbose)
    for (const StageCost& stage : result.stages)
      std::printf("  %-16s %9.2f s\n", stage.name.c_str(), stage.seconds);
  std::printf("%s", shiftLine().c_str());
  std::printf("written        ");
  for (const std::string& file : files)
    std::printf(" %s", file.c_str());
  std::printf("\n");
}
