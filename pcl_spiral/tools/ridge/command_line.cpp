// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.h"

#include "job_check.h"
#include "passes/pass_options.h"
#include "program/program_options.h"
#include "terminal/command_line.h"
#include "terminal/read_options.h"
#include "terminal/vocabulary.h"

#include <algorithm>

using namespace pcl_spiral;

namespace {

OptionGroup
files(Job& job)
{
  OptionGroup group{
      "Files",
      {textOption("rail", "FILE",
                  "points measured along the ridge, in any order: .pcd .ply .xyz .txt .csv; as first file --rail can be left out",
                  job.rail),
       textOption("generator", "FILE",
                  "points measured once across the ridge, square to the rail; as second file --generator can be left out", job.generator),
       {"output", "FILE",
        "output file, its kind by extension; repeat it for each file: -o part.6d -o part.ngc\n"
        ".6d  one line per point: x y z and tool axis; an empty line between rows    .5d  x y z A C\n"
        ".csv .vtp  the rows with tool tips; Turn is the number of the row\n"
        ".pcd .ply  the rows of a ball cutter\n"
        ".ngc .nc .mpf .h  program for a machine; see --machine\n"
        ".apt .cls  CLDATA, of a cutter    .yaml  robot frames: metres, z along the tool axis; see --robot-z\n"
        ".json  report: settings, results for both lines, times; .html readable, with pictures and a scene to turn\n"
        ".png  picture of the rows on the ridge; also NAME_lines.png: both lines with frames, NAME_normals.png: error of the "
        "published normal, and with a machine NAME_rotary.png: rotary angles",
        [&job](const std::string& value) { job.outputs.push_back(value); }, true},
       textOption("scan", "FILE",
                  "scan of the whole part: with --through both lines are found in it; a cutter does not gouge it: --scan part.pcd",
                  job.scan)}};
  addOptions(group, readOptions(job.read));
  addOptions(group, scanOptions(job));
  addOptions(group, {configOption(job)});
  return group;
}

/** Places as X,Y,Z, separated by slashes. */
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
  OptionGroup group{
      "Ridge (mm, degrees)",
      {{"through", "X,Y,Z/...",
        "rough points on the ridge in --scan, in its coordinates, mm: at both ends, and between them where it bends: --through "
        "0,0,0/300,50,20/600,0,0",
        [&job](const std::string& value) { job.through = placesOf("through", value); }},
       numberOption("half-width", "L", "half width of the ridge in --scan, from its crest to each side: --half-width 12", job.half_width),
       switchOption("ring", "the ridge in --scan is closed", job.ring)}};
  addSettings(group, settingTable(job.ridge));
  return group;
}

OptionGroup
rows(Job& job)
{
  OptionGroup group{
      "Rows (mm, degrees); give one of --spot, --step-over and --scallop",
      {switchOption("one-way", "all rows in one direction; default back and forth", job.one_way),
       numberOption("spot", "MM", "diameter of a beam's spot: --spot 4", job.rows.spot_size),
       numberOption("step-over", "MM", "largest distance between neighbouring rows: --step-over 1", job.rows.step_over),
       numberOption("scallop", "MM", "largest ridge height that a ball may leave between rows: --scallop 0.02", job.scallop)}};
  addSettings(group, settingTable(job.rows));
  return group;
}

OptionTable
optionTable(Job& job)
{
  return {files(job),         ridge(job),
          rows(job),          cutterOptions(job, "without it the tool is a beam"),
          motionOptions(job), programOptions(job.program),
          runOptions(job)};
}

} // namespace

Job
parseCommandLine(int argc, const char* const* argv)
{
  return parseJob<Job>(argc, argv, optionTable, completeJob, {"rail", "generator"});
}

std::vector<std::string>
ownOptions()
{
  Job job;
  return namesOf(optionTable(job));
}

void
printHelp(std::ostream& out)
{
  Job job;
  out << "Makes rows of a beam or a cutter over a ridge, such as the edge of a press die, from two measured lines: a rail along the\n"
         "ridge and a generator once across it. Or from a full scan and a few rough points.\n\n"
         "  pcl_spiral_ridge RAIL GENERATOR -o OUT... --spot D --overlap SHARE [options]\n\n"
         "  pcl_spiral_ridge rail.pcd generator.pcd --spot 4 --overlap 0.25 --stand-off 10 -o ridge.6d -o ridge.png\n"
         "  pcl_spiral_ridge rail.pcd generator.pcd --tool-radius 6 --scallop 0.02 --machine xyzac.yaml -o ridge.ngc\n"
         "  pcl_spiral_ridge --scan part.pcd --through 0,0,0/300,50,20/600,0,0 --half-width 12 --step-over 2 -o ridge.csv\n\n"
         "Lengths are in millimetres, angles in degrees. Exit code: 0 on success, 1 if the data or a file fails, 2 if the\n"
         "command line is wrong. On 1 and 2 no output is written or changed.\n";
  printOptions(out, optionTable(job));
}
