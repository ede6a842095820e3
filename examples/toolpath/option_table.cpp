#include "option_table.h"
#include "program_options.h"
#include "terminal/option_values.h"

#include <algorithm>
#include <numeric>

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

/** An option for a number of the settings. */
Option
setting(const std::string& name, const std::string& argument, const std::string& help,
        double SpiralSettings::*member)
{
  return {name, argument, help,
          [name, member](Job& job, const std::string& value) { job.settings.*member = numberValue(name, value); }};
}

/** An option for a place of the settings. */
Option
setting(const std::string& name, const std::string& help,
        std::optional<Eigen::Vector3d> SpiralSettings::*member)
{
  return {name, "X,Y,Z", help,
          [name, member](Job& job, const std::string& value) { job.settings.*member = placeValue(name, value); }};
}

/** An option for a choice of the settings. */
template <typename Enum>
Option
setting(const std::string& name, const std::string& help, Enum SpiralSettings::*member)
{
  return {name, pcl_spiral::choiceList<Enum>(), help, [name, member](Job& job, const std::string& value) {
            job.settings.*member = choiceValue<Enum>(name, value);
          }};
}

/** A switch. */
Option
toggle(const std::string& name, const std::string& help, std::function<bool&(Job&)> member)
{
  return {name, "", help, [name, member](Job& job, const std::string& value) {
            if (value != "true" && value != "false")
              throw UsageError(name + ": " + value + ": must be true or false");
            member(job) = value == "true";
          }};
}

OptionGroup
files()
{
  using pcl_spiral::LengthUnit;
  return {
      "Files",
      {{"scan", "FILE",
        "the scan: .pcd .ply .xyz .txt .csv .asc .stl .obj; the name alone is enough: part.pcd",
        [](Job& job, const std::string& value) { job.scan = value; }},
       {"output", "FILE",
        "what to write, by extension; give it once a file: -o part.csv -o part.vtp\n"
        ".csv .pcd .ply .vtp  the path; with --verify a .vtp has the point data Deviation and Scallop, mm\n"
        ".ngc .nc  program of a five-axis machine; see --machine\n"
        ".apt .cls  CLDATA    .yaml  robot frames: metres, z out of the surface, x along the travel\n"
        ".json  report: settings, loops, counts, times\n"
        ".html  report to read and print, with the pictures, in one file\n"
        ".png  the spiral on the surface; NAME_lines.png beside it shows loops and radial lines; with --verify also "
        "NAME_deviation.png, NAME_stock.png, NAME_histogram.png, with a program NAME_rotary.png",
        [](Job& job, const std::string& value) { job.outputs.push_back(value); }},
       {"units", "mm|m|inch", "unit of the numbers in the scan; mm by default: --units m",
        [](Job& job, const std::string& value) { job.read.unit = choiceValue<LengthUnit>("units", value); }},
       {"origin", "X,Y,Z",
        "subtracted from the scan, in its own unit, for coordinates far from zero: --origin 393775,3689071,0",
        [](Job& job, const std::string& value) { job.read.origin = placeValue("origin", value); }},
       {"columns", "NAMES", "columns of a text file from the left; x, y and z are taken: --columns id,x,y,z",
        [](Job& job, const std::string& value) { job.read.columns = listValue(value); }},
       {"config", "FILE",
        "job file in YAML with these names (tool-radius: 10); the command line wins: --config job.yaml",
        [](Job&, const std::string&) {}}}};
}

OptionGroup
cutter()
{
  return {"Cutter and finish (mm, degrees)",
          {setting("tool-radius", "R", "radius of the ball cutter; needed: --tool-radius 10",
                   &SpiralSettings::tool_radius),
           setting("scallop", "H", "height of the ridge left between turns; needed: --scallop 0.05",
                   &SpiralSettings::scallop_height),
           setting("chord-error", "E", "linear moves stay this near the curve; 0.005: --chord-error 0.002",
                   &SpiralSettings::chord_error),
           setting("max-step", "L", "longest linear move; the tool radius by default: --max-step 5",
                   &SpiralSettings::max_step),
           setting("tilt", "A", "side tilt of the axis about the feed; 15: --tilt 0",
                   &SpiralSettings::tilt_angle),
           setting("lead", "A", "lead of the axis along the feed; 0: --lead 5", &SpiralSettings::lead_angle),
           setting("max-axis-rate", "D", "largest turn of the axis, degrees a mm; 10: --max-axis-rate 4",
                   &SpiralSettings::max_axis_rate),
           setting("axis-smoothing", "L",
                   "smooths out of the axis what is shorter than this along the path; 50, and 0 for none: "
                   "--axis-smoothing 20",
                   &SpiralSettings::axis_smoothing),
           setting("axis-deviation", "A",
                   "smoothing stays this near the tilt asked for, in the mean over its length; 2: --axis-deviation 1",
                   &SpiralSettings::axis_deviation),
           setting("feed", "F", "at the contact, mm/min; 1000: --feed 2500", &SpiralSettings::feed)}};
}

OptionGroup
spiral()
{
  return {
      "Spiral",
      {setting("center", "centre of a part with one boundary; found by default: --center 0,0,860",
               &SpiralSettings::centre),
       setting("start", "the first radial line ends nearest here: --start 1650,0,0",
               &SpiralSettings::start_point),
       setting("boundaries", "one for a dome, two for a ring; auto by default: --boundaries two",
               &SpiralSettings::boundary_mode),
       setting("direction", "outward by default: --direction inward", &SpiralSettings::direction),
       setting("sense", "which way the cutter travels round, seen from outside; ccw by default: --sense cw", &SpiralSettings::sense),
       setting("pitch", "distance of turns across the feed, or along the lines as published: --pitch along",
               &SpiralSettings::pitch),
       setting("lines", "how radial lines are found; auto by default: --lines harmonic",
               &SpiralSettings::lines),
       setting("gaps", "holes in the data are bridged by default: --gaps refuse", &SpiralSettings::gaps)}};
}

OptionGroup
surface()
{
  return {"Surface",
          {setting("view-point", "where the scanner stood, mm; normals face it: --view-point 0,0,3000",
                   &SpiralSettings::view_point),
           toggle("flip-normals", "the cutter is on the other side",
                  [](Job& job) -> bool& { return job.settings.flip_normals; }),
           toggle("largest", "of several separate parts keep the largest one alone: --largest",
                  [](Job& job) -> bool& { return job.settings.largest_part; }),
           setting("thin", "EDGE", "thin to one point a cube of this edge, mm; 0, none: --thin 2",
                   &SpiralSettings::thinning),
           {"outliers", "K,SIGMA", "drop points that far, in deviations, from K neighbours: --outliers 16,3",
            setOutliers}}};
}

OptionGroup
running()
{
  return {"Run",
          {{"threads", "N", "0, the default, means all; the path does not depend on it: --threads 4",
            [](Job& job, const std::string& value) { job.settings.threads = wholeNumberValue("threads", value); }},
           toggle("verify", "judge the path by the scan: deviation, scallop, gouge; adds about as much time again",
                  [](Job& job) -> bool& { return job.verify; }),
           toggle("verbose", "say more: what each stage cost", [](Job& job) -> bool& { return job.verbose; }),
           toggle("quiet", "say nothing but errors", [](Job& job) -> bool& { return job.quiet; }),
           toggle("help", "this text", [](Job& job) -> bool& { return job.help; }),
           toggle("version", "print the version", [](Job& job) -> bool& { return job.version; })}};
}

/** Least count of letters to change, add or drop (Levenshtein 1966). */
std::size_t
editDistance(const std::string& a, const std::string& b)
{
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i - 1] != b[j - 1]);
      diagonal = row[j];
      row[j] = std::min({changed, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

} // namespace

const std::vector<OptionGroup>&
optionTable()
{
  static const std::vector<OptionGroup> table{files(), cutter(), spiral(), surface(), programOptions(), running()};
  return table;
}

const Option*
findOption(const std::string& name)
{
  for (const OptionGroup& group : optionTable())
    for (const Option& option : group.options)
      if (option.name == name)
        return &option;
  return nullptr;
}

std::string
suggestion(const std::string& name)
{
  std::string nearest;
  std::size_t least = std::max<std::size_t>(3, name.size() / 2);
  for (const OptionGroup& group : optionTable())
    for (const Option& option : group.options) {
      const bool begins = name.size() >= 3 && option.name.rfind(name, 0) == 0;
      const std::size_t distance = begins ? 0 : editDistance(name, option.name);
      if (distance < least) {
        least = distance;
        nearest = option.name;
      }
    }
  return nearest.empty() ? std::string() : "; did you mean '" + nearest + "'?";
}
