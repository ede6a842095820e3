// SPDX-License-Identifier: BSD-3-Clause
#include "pass_options.h"

#include <algorithm>

namespace {

/** Segments as RADIUS,LENGTH or LOWER,UPPER,LENGTH, between them a slash, from the flank upwards. */
std::vector<pcl_spiral::ToolSegment>
segmentsOf(const std::string& value)
{
  std::vector<pcl_spiral::ToolSegment> segments;
  for (const std::string& piece : piecesOf(value)) {
    const std::vector<std::string> words = listValue(piece);
    if (words.size() != 2 && words.size() != 3)
      throw UsageError("--holder " + value +
                       ": segments of radius,length or lower radius,upper radius,length are needed, from the flank "
                       "upwards, such as 6,40/20,25,60");
    const double lower = numberValue("holder", words[0]);
    const double upper = words.size() == 3 ? numberValue("holder", words[1]) : lower;
    segments.push_back(
        {lower, upper, numberValue("holder", words.back()), "segment " + std::to_string(segments.size() + 1) + " of the holder"});
  }
  return segments;
}

} // namespace

std::vector<Option>
readOptions(PassJob& job)
{
  return {choiceOption("units", "unit of the numbers in the files; mm by default: --units m", job.read.unit),
          placeOption("origin", "subtracted from the points, in their own unit: --origin 393775,3689071,0", job.read.origin),
          {"columns", "NAMES", "columns of a text file from the left; x, y and z are taken: --columns id,x,y,z",
           [&job](const std::string& value) { job.read.columns = listValue(value); }}};
}

std::vector<Option>
scanOptions(PassJob& job)
{
  return {switchOption("leave-out-strays",
                       "leave out points off the scanned surface, false echoes as a rule; the cutter stays above every point "
                       "otherwise",
                       job.leave_out_strays),
          switchOption("largest", "of several separate parts drive on the largest one alone; the cutter stays above the others' points",
                       job.largest_part),
          numberOption("thin", "EDGE",
                       "make the surface of one point a cube of this edge, mm; the cutter stays above all of them; 0, none: "
                       "--thin 0.5",
                       job.thinning)};
}

Option
configOption(PassJob& job)
{
  return textOption("config", "FILE", "job file in YAML with these names; the command line wins: --config job.yaml", job.config_file);
}

OptionGroup
cutterOptions(PassJob& job, const std::string& need)
{
  return {"Cutter (mm, degrees): a tapered bull-nose and its special cases",
          {numberOption("tool-radius", "R", "radius where the flank ends; " + need + ": --tool-radius 6", job.cutter.radius),
           numberOption("corner-radius", "r", "of the fillet; the largest there is by default, a ball: --corner-radius 1",
                        job.cutter.corner_radius),
           numberOption("flank-length", "L", "of the cutting flank, along it; 0: --flank-length 20", job.cutter.flank_length),
           numberOption("flank-angle", "A", "of the flank to the axis; 0: --flank-angle 5", job.cutter.flank_angle),
           {"holder", "SEGMENTS", "what stands on the flank, upwards, each as radius,length or lower,upper,length: --holder 6,40/20,25,60",
            [&job](const std::string& value) { job.holder = segmentsOf(value); }},
           numberOption("holder-clearance", "L", "kept between holder and scan; 0: --holder-clearance 1", job.holder_clearance),
           numberOption("feed", "F", "at the contact, mm/min; 1000: --feed 2500", job.feed)}};
}

Option
toleranceOption(PassJob& job)
{
  return numberOption("tolerance", "E",
                      "points are put between until no straight move cuts deeper or leaves more; 0.01: "
                      "--tolerance 0.005",
                      job.tolerance);
}

std::vector<Option>
axisOptions(PassJob& job)
{
  return {numberOption("axis-smoothing", "L",
                       "smooths out of the axes what is shorter than this along a pass, by up to 20 degrees in the mean; 0, "
                       "none: --axis-smoothing 20",
                       job.axis_smoothing),
          numberOption("max-axis-rate", "D", "largest turn of the axis, degrees a mm; 0, no limit: --max-axis-rate 4", job.max_axis_rate)};
}

OptionGroup
runOptions(PassJob& job)
{
  return {"Run",
          {threadsOption("the path does not depend on it", job.threads), switchOption("verbose", "say more", job.verbose),
           switchOption("quiet", "say nothing but errors", job.quiet), switchOption("help", "this text", job.help),
           switchOption("version", "print the version", job.version)}};
}
