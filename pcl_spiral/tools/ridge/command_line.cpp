// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.h"

#include "job_check.h"
#include "passes/pass_options.h"
#include "program/program_options.h"
#include "terminal/command_line.h"
#include "terminal/file_names.h"
#include "terminal/setter_names.h"

#include <algorithm>

using namespace pcl_spiral;

namespace {

OptionGroup
files(Job& job)
{
  OptionGroup group{
      "Files",
      {textOption("rail", "FILE", "points measured along the ridge, in any order: .pcd .ply .xyz .txt .csv; the first name alone is enough",
                  job.rail),
       textOption("generator", "FILE", "points measured once across the ridge, square to the rail; the second name alone is enough",
                  job.generator),
       {"output", "FILE",
        "what to write, by extension; give it once a file: -o part.6d -o part.ngc\n"
        ".6d  x y z and tool axis a line, a blank line between rows    .5d  x y z A C\n"
        ".csv .vtp  the rows with their tips; Turn counts rows    .pcd .ply  of a ball cutter\n"
        ".ngc .nc  program of a five-axis machine; see --machine\n"
        ".apt .cls  CLDATA    .yaml  robot frames of a ball cutter; a single row\n"
        ".json  report: settings, what was found of both lines, times\n"
        ".png  the rows on the shaded ridge; beside it NAME_lines.png: both lines with frames, NAME_normals.png: how far the published "
        "normal is off, and with a machine NAME_rotary.png: rotary angles",
        [&job](const std::string& value) { job.outputs.push_back(value); }},
       textOption("scan", "FILE",
                  "a scan of the whole part: with --through both lines are found in it; a cutter keeps clear of it: --scan part.pcd",
                  job.scan)}};
  addOptions(group, readOptions(job));
  addOptions(group, scanOptions(job));
  addOptions(group, {configOption(job)});
  return group;
}

/** Places as X,Y,Z, between them a slash. */
Polyline
placesOf(const std::string& option, const std::string& value)
{
  Polyline places;
  for (const std::string& piece : piecesOf(value))
    places.push_back(placeValue(option, piece));
  return places;
}

OptionGroup
ridge(Job& job)
{
  return {
      "Ridge (mm, degrees)",
      {placeOption("reference",
                   "normal of the plane with which the generator's chord keeps its angle, and the side that is up; for a rail that stands "
                   "upright take a direction across it; 0,0,1: --reference 1,0,0",
                   job.ridge.reference),
       numberOption("measuring-error", "S",
                    "standard deviation of a coordinate of the measured points; 0, found from them: --measuring-error 0.02",
                    job.ridge.measuring_error),
       switchOption("flip-normals", "the tool is on the other side", job.ridge.flip),
       {"through", "X,Y,Z/...",
        "rough points of the ridge in --scan, at its ends and, where it bends, between: --through 0,0,0/300,50,20/600,0,0",
        [&job](const std::string& value) { job.through = placesOf("through", value); }},
       numberOption("half-width", "L", "of the ridge in --scan, from its crest to either side: --half-width 12", job.half_width),
       switchOption("ring", "the ridge in --scan is closed", job.ring)}};
}

OptionGroup
rows(Job& job)
{
  RidgeRowSettings& s = job.rows;
  OptionGroup group{
      "Rows (mm, degrees); one of --spot, --step-over and --scallop is needed",
      {choiceOption("direction", "rows along the rail or across it; along: --direction across", s.direction),
       switchOption("one-way", "rows all in one direction; to and fro by default", job.one_way),
       numberOption("spot", "D", "diameter of a beam's spot: --spot 4", s.spot_size),
       numberOption("overlap", "SHARE", "share of the spot that the next row covers again, below 1; 0: --overlap 0.25", s.overlap),
       numberOption("step-over", "D", "largest distance of neighbouring rows: --step-over 1", s.step_over),
       numberOption("scallop", "H", "height of the ridges that a ball may leave between rows: --scallop 0.02", job.scallop),
       numberOption("point-spacing", "D", "largest distance of consecutive points; 1: --point-spacing 0.5", s.point_spacing),
       choiceOption("steps", "points equally far apart on each row, or as published at equal stations of the rail; equal: --steps stations",
                    s.steps),
       choiceOption("normals",
                    "true ones; as published, in the rail's normal plane, off where the ridge twists; or out of an arc through start, "
                    "middle and end of the generator; true: --normals in-plane",
                    s.normals),
       numberOption("stand-off", "L", "of a beam's tip from the surface, along the normal; 0: --stand-off 10", s.stand_off),
       numberOption("lead", "A", "of the tool axis, forward along the row; 0: --lead 5", s.lead),
       numberOption("tilt", "A", "of the tool axis, to the right of travel; 0: --tilt 5", s.tilt),
       numberOption("run-in", "L", "each row begins so far before the ridge, straight on, with --pass-begin said before it; 0: --run-in 3",
                    s.run_in),
       numberOption("run-out", "L", "each row goes on so far behind the ridge, with --pass-end said behind it; 0: --run-out 3", s.run_out),
       toleranceOption(job)}};
  addOptions(group, axisOptions(job));
  return group;
}

OptionTable
optionTable(Job& job)
{
  return {files(job),     ridge(job), rows(job), cutterOptions(job, "without it the tool is a beam"), programOptions(job.program),
          runOptions(job)};
}

} // namespace

Job
parseCommandLine(int argc, const char* const* argv)
{
  Job job;
  job.command = commandLine(argc, argv);
  job.given = setOptions(optionTable(job), argc, argv, {"rail", "generator"});
  if (!job.help && !job.version)
    completeJob(job);
  return job;
}

bool
hasOption(const std::string& name)
{
  Job job;
  return findOption(optionTable(job), name) != nullptr;
}

void
printHelp(std::ostream& out)
{
  Job job;
  out << "Rows of a beam or a cutter over a ridge, such as the edge of a press die, out of two measured lines: a rail along it, and a\n"
         "generator once across it. Or out of a full scan and a few rough points.\n\n"
         "  pcl_spiral_ridge RAIL GENERATOR -o OUT... --spot D --overlap SHARE [options]\n\n"
         "  pcl_spiral_ridge rail.pcd generator.pcd --spot 4 --overlap 0.25 --stand-off 10 -o ridge.6d -o ridge.png\n"
         "  pcl_spiral_ridge rail.pcd generator.pcd --tool-radius 6 --scallop 0.02 --machine xyzac.yaml -o ridge.ngc\n"
         "  pcl_spiral_ridge --scan part.pcd --through 0,0,0/300,50,20/600,0,0 --half-width 12 --step-over 2 -o ridge.csv\n\n"
         "Lengths are millimetres and angles degrees. Ends with 0 when done, 1 when the data or a file fails,\n"
         "2 when the call is wrong; then no output is written or changed.\n";
  printOptions(out, optionTable(job));
}
