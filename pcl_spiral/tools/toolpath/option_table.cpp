// SPDX-License-Identifier: BSD-3-Clause
#include "option_table.h"
#include "program/program_options.h"

using pcl_spiral::SpiralSettings;

namespace {

void
setOutliers(Job& job, const std::string& value)
{
  const std::vector<std::string> words = listValue(value);
  if (words.size() != 2)
    throw UsageError("--outliers " + value + ": neighbours and standard deviations are needed, such as 16,3");
  job.settings.outlier_neighbours = wholeNumberValue("outliers", words[0]);
  job.settings.outlier_deviations = numberValue("outliers", words[1]);
  if (job.settings.outlier_neighbours < 1 || job.settings.outlier_deviations <= 0.0)
    throw UsageError("--outliers " + value + ": both numbers must be above 0, such as 16,3");
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
    throw UsageError("--rim " + value + ": write on, or inside or beyond with a distance in mm, such as beyond,2");
  const double distance = numberValue("rim", words[1]);
  requireOption(distance >= 0.0, "rim", distance, "the distance must be 0 mm or more");
  overhang = beyond ? distance : -distance;
}

OptionGroup
files(Job& job)
{
  using pcl_spiral::LengthUnit;
  return {"Files",
          {{"scan", "FILE", "the scan: .pcd .ply .xyz .txt .csv .asc .stl .obj, or with --mesh a mesh; the name alone is enough: part.pcd",
            [&job](const std::string& value) { job.scan = value; }},
           {"output", "FILE",
            "what to write, by extension; give it once a file: -o part.csv -o part.vtp\n"
            ".csv .pcd .ply .vtp  the path; with --verify a .vtp has the point data Deviation and Scallop, mm\n"
            ".ngc .nc  program of a five-axis machine; see --machine\n"
            ".apt .cls  CLDATA    .yaml  robot frames: metres, z out of the surface, x along the travel\n"
            ".json  report: settings, loops, counts, times\n"
            ".html  report to read and print, with the pictures, in one file\n"
            ".png  the spiral on the surface; NAME_lines.png beside it shows loops and radial lines; with --verify also "
            "NAME_deviation.png, NAME_stock.png, NAME_histogram.png, with a program NAME_rotary.png",
            [&job](const std::string& value) { job.outputs.push_back(value); }},
           {"units", "mm|m|inch", "unit of the numbers in the scan; mm by default: --units m",
            [&job](const std::string& value) { job.read.unit = choiceValue<LengthUnit>("units", value); }},
           {"origin", "X,Y,Z", "subtracted from the scan, in its own unit, for coordinates far from zero: --origin 393775,3689071,0",
            [&job](const std::string& value) { job.read.origin = placeValue("origin", value); }},
           {"columns", "NAMES", "columns of a text file from the left; x, y and z are taken: --columns id,x,y,z",
            [&job](const std::string& value) { job.read.columns = listValue(value); }},
           textOption("config", "FILE", "job file in YAML with these names (tool-radius: 10); the command line wins: --config job.yaml",
                      job.config_file)}};
}

OptionGroup
cutter(SpiralSettings& s)
{
  return {
      "Cutter and finish (mm, degrees)",
      {numberOption("tool-radius", "R", "radius of the ball cutter; needed: --tool-radius 10", s.tool_radius),
       numberOption("scallop", "H", "height of the ridge left between turns; needed: --scallop 0.05", s.scallop_height),
       numberOption("chord-error", "E", "linear moves stay this near the curve; 0.005: --chord-error 0.002", s.chord_error),
       numberOption("max-step", "L", "longest linear move; the tool radius by default: --max-step 5", s.max_step),
       numberOption("tilt", "A", "side tilt of the axis about the feed; 15: --tilt 0", s.tilt_angle),
       numberOption("lead", "A", "lead of the axis along the feed; 0: --lead 5", s.lead_angle),
       numberOption("max-axis-rate", "D", "largest turn of the axis, degrees a mm; 10: --max-axis-rate 4", s.max_axis_rate),
       numberOption("axis-smoothing", "L",
                    "smooths out of the axis what is shorter than this along the path; 50, and 0 for none: "
                    "--axis-smoothing 20",
                    s.axis_smoothing),
       numberOption("axis-deviation", "A",
                    "smoothing stays this near the tilt asked for, in the mean over its length; 2: --axis-deviation 1", s.axis_deviation),
       numberOption("feed", "F", "at the contact, mm/min; 1000: --feed 2500", s.feed),
       numberOption("acceleration", "A", "of the machine, mm/s2: what sharp turns cost; 2000: --acceleration 500", s.acceleration)}};
}

OptionGroup
spiral(SpiralSettings& s)
{
  return {"Spiral",
          {placeOption("center", "centre of a part with one boundary; found by default: --center 0,0,860", s.centre),
           placeOption("start", "the path meets the rim nearest here: --start 1650,0,0", s.start_point),
           choiceOption("boundaries", "one: the rim; two: and the longest hole; all: and every hole; auto by default: --boundaries two",
                        s.boundary_mode),
           choiceOption("holes", "the path runs around holes, the default, or over them; or refuses them: --holes over", s.holes),
           numberOption("hole-size", "W",
                        "a narrower hole, mm, is but a gap in the data, ridden over and marked; found by default, with --mesh one "
                        "step-over, or six of its samples if that is more: --hole-size 8",
                        s.hole_size),
           numberOption("hole-margin", "D", "the path stays this far from holes, mm; 0: --hole-margin 1", s.hole_margin),
           {"rim", "on|inside,D|beyond,D", "where the pass along the rim runs, D mm off it; on by default: --rim beyond,2",
            [&s](const std::string& value) { setRim(s.rim_overhang, value); }},
           choiceOption("direction", "outward by default: --direction inward", s.direction),
           choiceOption("sense", "which way the cutter travels round, seen from outside; ccw by default: --sense cw", s.sense),
           switchOption("one-way", "cut in that sense alone: several passes, lifts between, where loops lie beside each other", s.one_way),
           choiceOption("method",
                        "shortest, the default: of the two that follow the one foreseen to take less machine time; radial: turns about a "
                        "centre or a hole; constant-scallop: loops along rim and holes, linked to one path; published: the chain of Wu "
                        "et al. 2025, to compare with: --method radial",
                        s.method),
           numberOption("turn-radius", "R", "warn of turns of a smaller radius, in step-overs, 0 to 0.25; 0.2: --turn-radius 0.1",
                        s.least_turn_radius),
           choiceOption("pitch", "distance of turns across the feed, or along the lines as published: --pitch along", s.pitch),
           choiceOption("lines", "how radial lines are found; auto by default: --lines harmonic", s.lines),
           choiceOption("gaps", "holes in the data are bridged by default: --gaps refuse", s.gaps)}};
}

OptionGroup
surface(Job& job)
{
  return {"Surface",
          {switchOption("mesh",
                        "the file is a mesh, .stl .obj .ply: the path follows samples of the curved surface behind its faces, which tell "
                        "the side; without it vertices are points of a scan",
                        job.mesh),
           numberOption("sample-spacing", "D",
                        "of the samples of --mesh, mm; by default found from its curvature and the step-over: --sample-spacing 0.5",
                        job.sample_spacing),
           placeOption("view-point", "where the scanner stood, mm; normals face it: --view-point 0,0,3000", job.settings.view_point),
           switchOption("flip-normals", "the cutter is on the other side of the scan or mesh", job.settings.flip_normals),
           switchOption("largest", "of several separate parts keep the largest one alone: --largest", job.settings.largest_part),
           numberOption("thin", "EDGE", "thin to one point a cube of this edge, mm; 0, none: --thin 2", job.settings.thinning),
           {"outliers", "K,SIGMA", "drop points that far, in deviations, from K neighbours: --outliers 16,3",
            [&job](const std::string& value) { setOutliers(job, value); }}}};
}

OptionGroup
running(Job& job)
{
  return {
      "Run",
      {threadsOption("the path does not depend on it", job.settings.threads),
       switchOption("verify", "judge the path by the scan or mesh: deviation, scallop, gouge; adds about as much time again", job.verify),
       switchOption("verbose", "say more: what each stage cost", job.verbose), switchOption("quiet", "say nothing but errors", job.quiet),
       switchOption("help", "this text", job.help), switchOption("version", "print the version", job.version)}};
}

} // namespace

OptionTable
optionTable(Job& job)
{
  return {files(job), cutter(job.settings), spiral(job.settings), surface(job), programOptions(job.program), running(job)};
}
