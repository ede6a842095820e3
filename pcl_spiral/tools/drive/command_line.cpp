// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.h"
#include "job_check.h"
#include "passes/pass_options.h"
#include "program/program_options.h"
#include "terminal/command_line.h"
#include "terminal/file_names.h"
#include "terminal/setter_names.h"

using pcl_spiral::DriveAxisMode;

namespace {

OptionGroup
files(Job& job)
{
  OptionGroup group{
      "Files",
      {textOption("scan", "FILE", "the scan: .pcd .ply .xyz .txt .csv .asc .stl .obj; the name alone is enough: part.pcd", job.scan),
       {"output", "FILE",
        "what to write, by extension; give it once a file: -o part.csv -o part.ngc\n"
        ".csv .vtp  the path with its tips; Turn counts passes    .pcd .ply  of a ball cutter\n"
        ".ngc .nc  program of a five-axis machine; see --machine\n"
        ".apt .cls  CLDATA    .yaml  robot frames of a ball cutter; a single pass\n"
        ".json  report: settings, counts, states, collisions, times\n"
        ".png  the passes on the shaded part; with a machine NAME_rotary.png beside it: rotary angles",
        [&job](const std::string& value) { job.outputs.push_back(value); }},
       switchOption("mesh",
                    "the file is a mesh, .stl .obj .ply, and its faces count: planes are sections of the curved surface behind "
                    "them; without it the vertices are a scan",
                    job.mesh),
       numberOption("crease-angle", "A", "edges of a mesh bent by more stay sharp, degrees; 30: --crease-angle 20",
                    job.mesh_settings.crease_angle),
       switchOption("flip-normals", "the cutter is on the other side of a mesh's faces", job.mesh_settings.flip)}};
  addOptions(group, readOptions(job));
  addOptions(group, scanOptions(job));
  addOptions(group, {configOption(job)});
  return group;
}

OptionGroup
path(Job& job)
{
  pcl_spiral::DriveSettings& s = job.drive;
  OptionGroup group{
      "Drive path (mm, degrees)",
      {choiceOption("drive", "planes by default: --drive helix", s.kind),
       numberOption("step-over", "D", "largest distance of neighbouring passes; this or --scallop: --step-over 1", s.step_over),
       numberOption("scallop", "H",
                    "ridge left between passes on a plane; gives the step-over by the cutter's "
                    "profile: --scallop 0.02",
                    job.scallop),
       numberOption("point-spacing", "D",
                    "largest distance of drive points along a pass; 1, on a mesh the tool radius: --point-spacing 0.5", s.point_spacing),
       numberOption("overrun", "L", "helix and rings go on so far beyond the ends of the column, where it leans; 0: --overrun 1.5",
                    s.overrun),
       toleranceOption(job),
       switchOption("no-gouge-check",
                    "stand the cutter at the contacts of a mesh's sections without a look at the rest of the mesh: quicker, and "
                    "narrow hollows are cut into",
                    job.no_gouge_check),
       numberOption("direction", "A", "of planes' passes about the tool axis, from X; 0: --direction 45", s.plane_angle),
       choiceOption("rows", "planes even steps apart, or kept as close as --scallop of a ball asks anywhere; even: --rows kept", s.rows),
       switchOption("link", "planes' rows joined on the surface where the next begins within two step-overs", s.link_rows),
       switchOption("one-way", "planes all in one direction; to and fro by default", job.one_way),
       textOption("curve", "FILE", "the curve of --drive curve: points in order, formats as for a scan: --curve c.txt", job.curve_file),
       placeOption("column-axis",
                   "direction of the axis that helix and rings go round; found from the scan by default: "
                   "--column-axis 0,0,1",
                   job.column_axis),
       placeOption("column-centre", "a place on it; 0,0,0: --column-centre 20,5,0", job.column_centre),
       placeOption("axis", "tool axis, tip to shank, of --axis-mode fixed and of section planes; 0,0,1: --axis 0,1,1", s.axis),
       {"axis-mode", pcl_spiral::choiceList<DriveAxisMode>(),
        "where tool axes come from; cylinder for helix and rings, fixed for the others: --axis-mode surface",
        [&s](const std::string& value) { s.axis_mode = choiceValue<DriveAxisMode>("axis-mode", value); }}}};
  addOptions(group, axisOptions(job));
  return group;
}

OptionTable
optionTable(Job& job)
{
  return {files(job), cutterOptions(job, "needed"), path(job), programOptions(job.program), runOptions(job)};
}

} // namespace

Job
parseCommandLine(int argc, const char* const* argv)
{
  Job job;
  job.command = commandLine(argc, argv);
  job.given = setOptions(optionTable(job), argc, argv);
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
  out << "Gouge-free locations of any cutter along planes, a helix, rings, a curve or offsets of the boundary of a\n"
         "scanned surface or a mesh, three-axis or five-axis.\n\n"
         "  pcl_spiral_drive SCAN -o OUT... --tool-radius R --step-over D [options]\n\n"
         "  pcl_spiral_drive part.stl --mesh --tool-radius 5 --scallop 0.01 --rows kept --link -o part.csv\n"
         "  pcl_spiral_drive column.pcd --drive helix --tool-radius 4 --step-over 0.8 --machine xyzac.yaml -o part.ngc\n\n"
         "Lengths are millimetres and angles degrees. Ends with 0 when done, 1 when the data or a file fails,\n"
         "2 when the call is wrong; then no output is written or changed.\n";
  printOptions(out, optionTable(job));
}
