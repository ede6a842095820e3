// SPDX-License-Identifier: BSD-3-Clause
#include "option_table.h"
#include "judging/stock_option.h"
#include "program/holder_options.h"
#include "program/program_options.h"
#include "terminal/read_options.h"
#include "terminal/scan_places.h"

using pcl_spiral::SpiralSettings;

namespace {

void
setOutliers(Job& job, const std::string& value)
{
  const std::vector<std::string> words = listValue(value);
  if (words.size() != 2)
    throw UsageError(
        pcl_spiral::Diagnostic("--outliers ", value, ": give the number of neighbours and of standard deviations, such as 16,3"));
  job.settings.outlier_neighbours = wholeNumberValue("outliers", words[0]);
  job.settings.outlier_deviations = numberValue("outliers", words[1]);
  if (job.settings.outlier_neighbours < 1 || job.settings.outlier_deviations <= 0.0)
    throw UsageError(pcl_spiral::Diagnostic("--outliers ", value, ": both numbers must be above 0, such as 16,3"));
}

/** "on", "inside,2" or "beyond,2". */
void
setRim(double& overhang, const std::string& value)
{
  const std::vector<std::string> words = listValue(value);
  const bool beyond = words[0] == "beyond";
  if (words.size() == 1 && words[0] == "on") {
    overhang = 0.0;
    return;
  }
  if (words.size() != 2 || (!beyond && words[0] != "inside"))
    throw UsageError(pcl_spiral::Diagnostic("--rim ", value, ": give on, or inside or beyond with a distance in mm, such as beyond,2"));
  const double distance = numberValue("rim", words[1]);
  requireOption(distance >= 0.0, "rim", distance, "the distance must be at least 0 mm");
  overhang = beyond ? distance : -distance;
}

OptionGroup
files(Job& job)
{
  OptionGroup group{
      "Files",
      {{"scan", "FILE", ".pcd .ply .xyz .txt .csv .asc .pts .las .stl .obj, or with --mesh a mesh; --scan itself can be left out: part.pcd",
        [&job](const std::string& value) { job.scan = value; }},
       {"output", "FILE",
        "output file, its kind by extension; repeat it for each file: -o part.csv -o part.vtp\n"
        ".csv .pcd .ply .vtp  the path; with --verify the .vtp also has the point data Deviation and Scallop, mm\n"
        ".ngc .nc .mpf .h  program for a machine; see --machine\n"
        ".apt .cls  CLDATA    .yaml  robot frames: metres, z along the tool axis; see --robot-z\n"
        ".json  report: settings, loops, counts, times\n"
        ".html  report to read and print, with the pictures, in one file\n"
        ".png  picture of the spiral on the surface; also NAME_lines.png: loops and radial lines; with --verify also "
        "NAME_deviation.png, NAME_stock.png, NAME_histogram.png; with a program NAME_rotary.png",
        [&job](const std::string& value) { job.outputs.push_back(value); }, true},
       textOption("reach", "FILE",
                  "map of the largest ball that reaches each point of the scan, up to four tool radii: .csv .pcd .ply with x, y, z and "
                  "radius, or a picture, .png: --reach reach.png",
                  job.reach),
       {"stock", "FILE", stock_help + std::string("; checks the path, as --verify does"),
        [&job](const std::string& value) {
          job.stock.push_back(value);
          job.verify = true;
        }},
       textOption("raw-scan", "FILE", raw_scan_help, job.raw_scan),
       textOption("config", "FILE",
                  "job file in YAML with these option names (tool-radius: 10), or the .json report of a run, which is then made "
                  "again; the command line has priority: --config job.yaml",
                  job.config_file)}};
  addOptions(group, readOptions(job.read));
  return group;
}

OptionGroup
cutter(Job& job)
{
  SpiralSettings& s = job.settings;
  OptionGroup group{
      "Cutter and finish (mm, degrees)",
      {numberOption("tool-radius", "R", "radius of the ball cutter; required: --tool-radius 10", s.tool_radius),
       numberOption("scallop", "H", "scallop height, the largest ridge between turns; required: --scallop 0.05", s.scallop_height),
       numberOption("chord-error", "E", "largest distance of linear moves from the curve; default 0.005: --chord-error 0.002",
                    s.chord_error),
       numberOption("max-step", "L", "longest linear move; default the tool radius: --max-step 5", s.max_step),
       numberOption("tilt", "A", "side tilt of the axis about the feed direction; default 15: --tilt 0", s.tilt_angle),
       numberOption("lead", "A", "lead of the axis along the feed direction; default 0: --lead 5", s.lead_angle),
       placeOption("axis",
                   "one tool axis for the whole path, from tip to shank, instead of tilt and lead, for machines with three axes or one "
                   "fixed tilt: --axis 0,0,1",
                   s.fixed_axis),
       numberOption("max-axis-rate", "D", "largest turn of the axis, degrees per mm; default 10: --max-axis-rate 4", s.max_axis_rate),
       numberOption("axis-smoothing", "L",
                    "smooths changes of the axis shorter than this along the path; default 50, 0 for no smoothing: "
                    "--axis-smoothing 20",
                    s.axis_smoothing),
       numberOption("axis-deviation", "A",
                    "largest change of the tilt by smoothing, on average over its length; default 2: --axis-deviation 1", s.axis_deviation),
       numberOption("feed", "F", "feed at the contact, mm/min; default 1000: --feed 2500", s.feed),
       numberOption("acceleration", "A",
                    "acceleration of the machine, mm/s2; used for the time of sharp turns; default 2000: --acceleration 500",
                    s.acceleration),
       numberOption("flank-length", "L",
                    "length of the shank, as wide as the ball, from the centre of the ball up to the holder; needed with --holder: "
                    "--flank-length 20",
                    job.flank_length)}};
  addOptions(group, holderOptions(job.holder, job.holder_clearance));
  return group;
}

OptionGroup
spiral(SpiralSettings& s)
{
  return {
      "Spiral",
      {placeOption("center", "centre of a part with one boundary, mm, in the scan's coordinates; default found: --center 0,0,860",
                   s.centre),
       placeOption("start", "the path meets the rim nearest to this place, mm, in the scan's coordinates: --start 1650,0,0", s.start_point),
       choiceOption("boundaries",
                    "one: the rim; two: the rim and the longest hole; all: the rim and every hole; default auto: --boundaries two",
                    s.boundary_mode),
       choiceOption("holes", "the path runs round holes or over them, or a part with holes is refused; default around: --holes over",
                    s.holes),
       numberOption("hole-size", "W",
                    "a hole narrower than this, mm, is a gap in the data: the path runs over it, marked; default found from the scan; with "
                    "--mesh one step-over, or six sample spacings if that is more: --hole-size 8",
                    s.hole_size),
       numberOption("hole-margin", "D", "distance of the path from holes, mm; default 0: --hole-margin 1", s.hole_margin),
       {"rim", "on|inside,D|beyond,D", "position of the pass along the rim, D mm inside or beyond it; default on: --rim beyond,2",
        [&s](const std::string& value) { setRim(s.rim_overhang, value); }},
       choiceOption("direction", "from the inside outward, or inward; default outward: --direction inward", s.direction),
       choiceOption("sense", "direction of travel round the part, seen from outside; default ccw: --sense cw", s.sense),
       switchOption("one-way", "cut only in the sense of --sense: several passes with lifts between them where loops are side by side",
                    s.one_way),
       choiceOption("method",
                    "shortest: radial or constant-scallop, whichever has the shorter predicted machining time; radial: turns about a "
                    "centre or a hole; constant-scallop: loops along rim and holes, linked to one path; published: the method of Wu "
                    "et al. 2025, for comparison; default shortest: --method radial",
                    s.method),
       numberOption("turn-radius", "R",
                    "warn of turns with a smaller radius than this, in step-overs, 0 to 0.25; default 0.2: --turn-radius 0.1",
                    s.least_turn_radius),
       choiceOption("pitch",
                    "where the distance of turns is measured: across the feed, or along the radial lines as published; default across: "
                    "--pitch along",
                    s.pitch),
       choiceOption("lines", "how radial lines are found; default auto: --lines harmonic", s.lines),
       choiceOption("tight",
                    "places that the ball does not reach: it rides over them without a gouge, and what stays is reported; or a hollow "
                    "tighter than the ball is refused; default ride: --tight refuse",
                    s.tight),
       choiceOption("gaps", "gaps in the data are bridged or refused; default bridge: --gaps refuse", s.gaps)}};
}

OptionGroup
surface(Job& job)
{
  OptionGroup group{
      "Surface",
      {switchOption("mesh",
                    "the file is a mesh, .stl .obj .ply: the path follows samples of the curved surface behind its faces, and the faces "
                    "define the side; without --mesh its vertices are a scan",
                    job.mesh),
       numberOption("sample-spacing", "D",
                    "spacing of the samples of --mesh, mm; default found from its curvature and the step-over: --sample-spacing 0.5",
                    job.sample_spacing),
       placeOption("view-point", view_point_help, job.settings.view_point),
       switchOption("flip-normals", "the cutter is on the other side of the scan or mesh", job.settings.flip_normals),
       switchOption("largest", "of several separate parts keep only the largest: --largest", job.settings.largest_part),
       numberOption("thin", "EDGE", "keep one point per cube of this edge, mm; default 0, no thinning: --thin 2", job.settings.thinning),
       {"outliers", "K,SIGMA", "remove points farther than SIGMA standard deviations from their K neighbours: --outliers 16,3",
        [&job](const std::string& value) { setOutliers(job, value); }}}};
  addOptions(group, regionOptions(job.part, job.regions));
  addOptions(group, {clustersOption(job.part)});
  return group;
}

/** A limit of the check, which is then made; \p what it limits. */
Option
limitOption(const std::string& name, const std::string& argument, const std::string& what, bool& verify, std::optional<double>& limit)
{
  return {name, argument, "check the path, and write nothing if this is exceeded: " + what,
          [name, &verify, &limit](const std::string& value) {
            limit = numberValue(name, value);
            if (!(*limit >= 0.0))
              throw UsageError(pcl_spiral::Diagnostic("--", name, " ", value, ": give 0 or more"));
            verify = true;
          }};
}

OptionGroup
running(Job& job)
{
  return {
      "Run",
      {threadsOption("the path does not depend on it", job.settings.threads),
       switchOption("verify", "check the path against the scan or mesh: deviation, scallop, gouge; about doubles the time", job.verify),
       limitOption("max-gouge", "G", "depth of gouges, mm: --max-gouge 0.01", job.verify, job.limits.gouge),
       limitOption("max-scallop", "S", "height of ridges and of stock at the rim, mm: --max-scallop 0.06", job.verify, job.limits.scallop),
       limitOption("max-deviation", "D", "distance of the contacts from the surface, mm: --max-deviation 0.02", job.verify,
                   job.limits.deviation),
       limitOption("max-uncut", "P", "points of the surface that are not cut, percent: --max-uncut 0", job.verify, job.limits.uncut),
       switchOption("verbose", "print more: the time of each stage", job.verbose), switchOption("quiet", "print only errors", job.quiet),
       switchOption("help", "print this text", job.help), switchOption("version", "print the version", job.version)}};
}

} // namespace

OptionTable
optionTable(Job& job)
{
  return {files(job), cutter(job), spiral(job.settings), surface(job), programOptions(job.program), running(job)};
}
