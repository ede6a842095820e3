// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.h"
#include "job_check.h"
#include "passes/pass_options.h"
#include "program/program_options.h"
#include "terminal/command_line.h"
#include "terminal/read_options.h"
#include "terminal/scan_places.h"
#include "terminal/vocabulary.h"

namespace {

OptionGroup
files(Job& job)
{
  OptionGroup group{"Files",
                    {textOption("scan", "FILE", "the scan: " + scanExtensions() + "; --scan itself can be left out: part.pcd", job.scan),
                     {"output", "FILE",
                      "output file, its kind by extension; repeat it for each file: -o part.csv -o part.ngc\n"
                      ".csv .vtp  the path with cutter tips; Turn is the number of the pass\n"
                      ".pcd .ply  the path of a ball cutter\n"
                      ".ngc .nc .mpf .h  program for a machine; see --machine\n"
                      ".apt .cls  CLDATA    .yaml  robot frames: metres, z along the tool axis; see --robot-z\n"
                      ".json  report: settings, counts, states, collisions, times; .html readable, with pictures\n"
                      ".png  picture of the passes on the part; with a machine also NAME_rotary.png: rotary angles",
                      [&job](const std::string& value) { job.outputs.push_back(value); }, true},
                     switchOption("mesh",
                                  "the file is a mesh, .stl .obj .ply, and its faces are used: planes cut the curved surface behind "
                                  "them; without --mesh its vertices are a scan",
                                  job.mesh),
                     placeOption("view-point", view_point_help, job.view_point)}};
  addOptions(group, {textOption("raw-scan", "FILE", raw_scan_help, job.raw_scan)});
  addOptions(group, readOptions(job.read));
  addOptions(group, scanOptions(job));
  addOptions(group, regionOptions(job.choice, job.regions));
  addOptions(group, {clustersOption(job.choice)});
  addOptions(group, {configOption(job)});
  addSettings(group, settingTable(job.mesh_settings));
  return group;
}

OptionGroup
path(Job& job)
{
  OptionGroup group{
      "Drive path (mm, degrees)",
      {choiceOption("rows", "planes: at even steps, or everywhere as close as --scallop needs; default kept with --scallop: --rows even",
                    job.drive.rows),
       numberOption("point-spacing", "MM",
                    "largest distance between drive points of a pass; default 1, on a mesh the tool radius: --point-spacing 0.5",
                    job.drive.point_spacing),
       numberOption("step-over", "MM", "largest distance between neighbouring passes; give this or --scallop: --step-over 1",
                    job.drive.step_over),
       numberOption("scallop", "MM",
                    "largest height of the ridge left between passes, on slopes too; refused, with the height that is reached, "
                    "where the passes leave more: --scallop 0.02",
                    job.drive.scallop_height),
       switchOption("no-gouge-check",
                    "put the cutter at the contacts of the mesh sections without checking the rest of the mesh: faster, but "
                    "it gouges narrow hollows",
                    job.no_gouge_check),
       switchOption("one-way", "cut all passes in one direction; default back and forth", job.one_way),
       textOption("curve", "FILE", "the curve for --drive curve: points in order, file formats as for a scan: --curve c.txt",
                  job.curve_file),
       placeOption("column-axis",
                   "direction of the axis that helix and rings go round; default found from the scan: "
                   "--column-axis 0,0,1",
                   job.column_axis),
       placeOption("column-centre", "a place on that axis, in the scan's coordinates, mm; default 0,0,0: --column-centre 20,5,0",
                   job.column_centre)}};
  addSettings(group, settingTable(job.drive));
  return group;
}

OptionTable
optionTable(Job& job)
{
  return {files(job), cutterOptions(job, "required"), path(job), motionOptions(job), programOptions(job.program), runOptions(job)};
}

} // namespace

Job
parseCommandLine(int argc, const char* const* argv)
{
  return parseJob<Job>(argc, argv, optionTable, completeJob);
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
  out << "Moves any cutter over a scanned surface or a mesh without gouges: along planes, a helix, rings, a curve or\n"
         "offsets of the boundary. For three or five axes.\n\n"
         "  pcl_spiral_drive SCAN -o OUT... --tool-radius R --step-over D [options]\n\n"
         "  pcl_spiral_drive part.stl --mesh --tool-radius 5 --scallop 0.01 --rows kept --link -o part.csv\n"
         "  pcl_spiral_drive column.pcd --drive helix --tool-radius 4 --step-over 0.8 --machine xyzac.yaml -o part.ngc\n\n"
         "Lengths are in millimetres, angles in degrees. Exit code: 0 on success, 1 if the data or a file fails, 2 if the\n"
         "command line is wrong. On 1 and 2 no output is written or changed.\n";
  printOptions(out, optionTable(job));
}
