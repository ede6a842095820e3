// SPDX-License-Identifier: BSD-3-Clause
#include "option_table.h"
#include "judging/stock_option.h"
#include "program/holder_options.h"
#include "program/program_options.h"
#include "terminal/read_options.h"
#include "terminal/scan_places.h"

#include "planning/input_tables.h"

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

/** --stock, which checks the path. */
Option
checkedStock(Job& job)
{
  Option option = stockOption(job.stock);
  option.help += "; checks the path, as --verify does";
  option.set = [set = option.set, &job](const std::string& value) {
    set(value);
    job.verify = true;
  };
  return option;
}

OptionGroup
files(Job& job)
{
  OptionGroup group{
      "Files",
      {{"scan", "FILE", scanExtensions() + ", or with --mesh a mesh; --scan itself can be left out: part.pcd",
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
       checkedStock(job),
       textOption("raw-scan", "FILE", raw_scan_help, job.raw_scan),
       configOption(job)}};
  addOptions(group, readOptions(job.read));
  return group;
}

OptionGroup
cutter(Job& job)
{
  OptionGroup group{"Cutter and finish (mm, degrees)", {}};
  addSettings(group, pcl_spiral::cutterTable(job.settings));
  addOptions(group,
             {numberOption("flank-length", "L",
                           "length of the shank, as wide as the ball, from the centre of the ball up to the holder; needed with --holder: "
                           "--flank-length 20",
                           job.flank_length)});
  addOptions(group, holderOptions(job.holder, job.holder_clearance));
  return group;
}

OptionGroup
spiral(SpiralSettings& s)
{
  OptionGroup group{
      "Spiral",
      {{"rim", "on|inside,D|beyond,D", "position of the pass along the rim, D mm inside or beyond it; default on: --rim beyond,2",
        [&s](const std::string& value) { setRim(s.rim_overhang, value); }}}};
  addSettings(group, pcl_spiral::turnTable(s));
  return group;
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
       switchOption("ball-closing",
                    "for a scan from one side with steps, folds and overhangs: plan over what the ball can touch when it comes down along "
                    "the tool axis: --axis, else towards the view point, else +z; the axis stays the same on the whole path",
                    job.ball_closing),
       {"outliers", "K,SIGMA", "remove points farther than SIGMA standard deviations from their K neighbours: --outliers 16,3",
        [&job](const std::string& value) { setOutliers(job, value); }}}};
  addSettings(group, settingTable(static_cast<pcl_spiral::SurfaceSettings&>(job.settings)));
  addSettings(group, {pcl_spiral::remedyTries(job.remedy_tries)});
  addOptions(group, regionOptions(job.part, job.regions));
  addOptions(group, {clustersOption(job.part)});
  return group;
}

/** The limits of the check, which is then made. */
std::vector<Option>
limitOptions(Job& job)
{
  OptionGroup limits;
  addSettings(limits, settingTable(job.limits));
  for (Option& option : limits.options) {
    option.help = "check the path, and write nothing if this is exceeded: " + option.help;
    option.set = [set = option.set, &job](const std::string& value) {
      set(value);
      job.verify = true;
    };
  }
  return limits.options;
}

OptionGroup
running(Job& job)
{
  OptionGroup group{
      "Run",
      {switchOption("verify", "check the path against the scan or mesh: deviation, scallop, gouge; about doubles the time", job.verify)}};
  addOptions(group, limitOptions(job));
  addOptions(group, {switchOption("verbose", "print more: the time of each stage", job.verbose)});
  addOptions(group, runOptions(job, job.settings.threads).options);
  return group;
}

} // namespace

OptionTable
optionTable(Job& job)
{
  return {files(job), cutter(job), spiral(job.settings), surface(job), programOptions(job.program), running(job)};
}
