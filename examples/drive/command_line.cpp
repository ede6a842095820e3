#include "command_line.h"
#include "job_check.h"
#include "program/program_options.h"
#include "terminal/command_line.h"
#include "terminal/file_names.h"
#include "terminal/setter_names.h"

#include <algorithm>

using pcl_spiral::DriveAxisMode;

namespace {

OptionGroup
files(Job& job)
{
  return {"Files",
          {textOption("scan", "FILE",
                      "the scan: .pcd .ply .xyz .txt .csv .asc .stl .obj; the name alone is enough: part.pcd", job.scan),
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
           numberOption("crease-angle", "A",
                        "edges of a mesh bent by more stay sharp, degrees; 30: --crease-angle 20", job.mesh_settings.crease_angle),
           switchOption("flip-normals", "the cutter is on the other side of a mesh's faces", job.mesh_settings.flip),
           choiceOption("units", "unit of the numbers in the scan; mm by default: --units m", job.read.unit),
           placeOption("origin", "subtracted from the scan, in its own unit: --origin 393775,3689071,0", job.read.origin),
           {"columns", "NAMES", "columns of a text file from the left; x, y and z are taken: --columns id,x,y,z",
            [&job](const std::string& value) { job.read.columns = listValue(value); }},
           switchOption("leave-out-strays",
                        "leave out points off the scanned surface, false echoes as a rule; the cutter stays above every point "
                        "otherwise",
                        job.leave_out_strays),
           switchOption("largest",
                        "of several separate parts drive on the largest one alone; the cutter stays above the others' points",
                        job.largest_part),
           numberOption("thin", "EDGE",
                        "make the surface of one point a cube of this edge, mm; the cutter stays above all of them; 0, none: "
                        "--thin 0.5",
                        job.thinning),
           textOption("config", "FILE", "job file in YAML with these names; the command line wins: --config job.yaml",
                      job.config_file)}};
}

/** Segments as RADIUS,LENGTH or LOWER,UPPER,LENGTH, between them a slash, from the flank upwards. */
std::vector<pcl_spiral::ToolSegment>
segmentsOf(const std::string& value)
{
  std::vector<pcl_spiral::ToolSegment> segments;
  for (std::size_t begin = 0; begin <= value.size();) {
    const std::size_t end = std::min(value.find('/', begin), value.size());
    const std::vector<std::string> words = listValue(value.substr(begin, end - begin));
    if (words.size() != 2 && words.size() != 3)
      throw UsageError("--holder " + value +
                       ": segments of radius,length or lower radius,upper radius,length are needed, from the flank "
                       "upwards, such as 6,40/20,25,60");
    const double lower = numberValue("holder", words[0]);
    const double upper = words.size() == 3 ? numberValue("holder", words[1]) : lower;
    segments.push_back({lower, upper, numberValue("holder", words.back()),
                        "segment " + std::to_string(segments.size() + 1) + " of the holder"});
    begin = end + 1;
  }
  return segments;
}

OptionGroup
cutter(Job& job)
{
  return {"Cutter (mm, degrees): a tapered bull-nose and its special cases",
          {numberOption("tool-radius", "R", "radius where the flank ends; needed: --tool-radius 6", job.cutter.radius),
           numberOption("corner-radius", "r", "of the fillet; the largest there is by default, a ball: --corner-radius 1",
                        job.cutter.corner_radius),
           numberOption("flank-length", "L", "of the cutting flank, along it; 0: --flank-length 20",
                        job.cutter.flank_length),
           numberOption("flank-angle", "A", "of the flank to the axis; 0: --flank-angle 5", job.cutter.flank_angle),
           {"holder", "SEGMENTS",
            "what stands on the flank, upwards, each as radius,length or lower,upper,length: --holder 6,40/20,25,60",
            [&job](const std::string& value) { job.holder = segmentsOf(value); }},
           numberOption("holder-clearance", "L", "kept between holder and scan; 0: --holder-clearance 1",
                        job.holder_clearance),
           numberOption("feed", "F", "at the contact, mm/min; 1000: --feed 2500", job.feed)}};
}

OptionGroup
path(Job& job)
{
  pcl_spiral::DriveSettings& s = job.drive;
  return {"Drive path (mm, degrees)",
          {choiceOption("drive", "planes by default: --drive helix", s.kind),
           numberOption("step-over", "D", "largest distance of neighbouring passes; this or --scallop: --step-over 1",
                        s.step_over),
           numberOption("scallop", "H", "ridge left between passes on a plane; gives the step-over by the cutter's "
                                        "profile: --scallop 0.02",
                        job.scallop),
           numberOption("point-spacing", "D", "largest distance of drive points along a pass; 1, on a mesh the tool radius: --point-spacing 0.5",
                        s.point_spacing),
           numberOption("overrun", "L",
                        "helix and rings go on so far beyond the ends of the column, where it leans; 0: --overrun 1.5",
                        s.overrun),
           numberOption("tolerance", "E",
                        "locations are put between until no straight move cuts deeper or leaves more; 0.01: "
                        "--tolerance 0.005",
                        job.tolerance),
           switchOption("no-gouge-check",
                        "stand the cutter at the contacts of a mesh's sections without a look at the rest of the mesh: quicker, and "
                        "narrow hollows are cut into",
                        job.no_gouge_check),
           numberOption("direction", "A", "of planes' passes about the tool axis, from X; 0: --direction 45", s.plane_angle),
           choiceOption("rows", "planes even steps apart, or kept as close as --scallop of a ball asks anywhere; even: --rows kept",
                        s.rows),
           switchOption("link", "planes' rows joined on the surface where the next begins within two step-overs", s.link_rows),
           switchOption("one-way", "planes all in one direction; to and fro by default", job.one_way),
           textOption("curve", "FILE", "the curve of --drive curve: points in order, formats as for a scan: --curve c.txt",
                      job.curve_file),
           placeOption("column-axis", "direction of the axis that helix and rings go round; found from the scan by default: "
                                      "--column-axis 0,0,1",
                       job.column_axis),
           placeOption("column-centre", "a place on it; 0,0,0: --column-centre 20,5,0", job.column_centre),
           placeOption("axis", "tool axis, tip to shank, of --axis-mode fixed and of section planes; 0,0,1: --axis 0,1,1",
                       s.axis),
           {"axis-mode", pcl_spiral::choiceList<DriveAxisMode>(),
            "where tool axes come from; cylinder for helix and rings, fixed for the others: --axis-mode surface",
            [&s](const std::string& value) { s.axis_mode = choiceValue<DriveAxisMode>("axis-mode", value); }},
           numberOption("axis-smoothing", "L",
                        "smooths out of the axes what is shorter than this along a pass, by up to 20 degrees in the mean; 0, "
                        "none: --axis-smoothing 20",
                        job.axis_smoothing),
           numberOption("max-axis-rate", "D", "largest turn of the axis, degrees a mm; 0, no limit: --max-axis-rate 4",
                        job.max_axis_rate)}};
}

OptionGroup
running(Job& job)
{
  return {"Run",
          {threadsOption("the path does not depend on it", job.threads),
           switchOption("verbose", "say more", job.verbose), switchOption("quiet", "say nothing but errors", job.quiet),
           switchOption("help", "this text", job.help), switchOption("version", "print the version", job.version)}};
}

OptionTable
optionTable(Job& job)
{
  return {files(job), cutter(job), path(job), programOptions(job.program), running(job)};
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
