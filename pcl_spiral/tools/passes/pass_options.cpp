// SPDX-License-Identifier: BSD-3-Clause
#include "pass_options.h"
#include "program/holder_options.h"
#include "terminal/cutter_shape.h"

std::vector<Option>
scanOptions(PassJob& job)
{
  return {
      switchOption("leave-out-strays",
                   "leave out outliers: points off the scanned surface, usually false echoes; without it the cutter stays above "
                   "every point",
                   job.leave_out_strays),
      switchOption("largest", "of several separate parts, machine only the largest; the cutter stays above the points of the others",
                   job.largest_part),
      numberOption("thin", "EDGE",
                   "make the surface from one point per cube of this edge, mm; the cutter stays above all points; default 0, no thinning: "
                   "--thin 0.5",
                   job.thinning)};
}

Option
configOption(PassJob& job)
{
  return textOption(
      "config", "FILE",
      "job file in YAML with these option names, or the .json report of a run, which is then made again; the command line has "
      "priority: --config job.yaml",
      job.config_file);
}

OptionGroup
cutterOptions(PassJob& job, const std::string& need)
{
  OptionGroup group{
      "Cutter (mm, degrees): tapered bull-nose and its special cases",
      {numberOption("tool-radius", "R", "radius at the upper end of the flank; " + need + ": --tool-radius 6", job.cutter.radius),
       numberOption("corner-radius", "r", corner_radius_help, job.cutter.corner_radius),
       numberOption("flank-length", "L",
                    "length of the cutting flank along its slant, without the tip: from the end of the corner to where the radius is R; "
                    "default 0: --flank-length 20",
                    job.cutter.flank_length),
       numberOption("flank-angle", "A", flank_angle_help, job.cutter.flank_angle)}};
  addOptions(group, holderOptions(job.holder, job.holder_clearance));
  addOptions(group,
             {numberOption("ceiling", "L",
                           "the cutter comes from this far above the surface, along its axis: what is higher, such as the opposite "
                           "wall of a bore, does not lift it; default the length of cutter and holder, without --holder ten radii or, "
                           "if the axis is fixed, no limit: --ceiling 60",
                           job.ceiling),
              numberOption("feed", "F", "feed at the contact, mm/min; default 1000: --feed 2500", job.feed)});
  return group;
}

Option
toleranceOption(PassJob& job)
{
  return numberOption("tolerance", "E",
                      "adds points until no straight move gouges more or leaves more than this; default 0.01: "
                      "--tolerance 0.005",
                      job.tolerance);
}

std::vector<Option>
axisOptions(PassJob& job)
{
  return {numberOption("axis-smoothing", "L",
                       "smooths changes of the axis shorter than this along a pass, by up to 20 degrees on average; default 0, "
                       "no smoothing: --axis-smoothing 20",
                       job.axis_smoothing),
          numberOption("max-retilt", "A",
                       "where the holder would collide, or the cutter be lifted off its contact on a mesh, turn the axis by up to this, "
                       "degrees; default 0, not at all: --max-retilt 30",
                       job.max_retilt),
          numberOption("retilt-step", "A",
                       "largest change of that turn from one point of a pass to the next, degrees; default 3: --retilt-step 1",
                       job.retilt_step),
          numberOption("max-axis-rate", "D", "largest turn of the axis, degrees per mm; default 0, no limit: --max-axis-rate 4",
                       job.max_axis_rate)};
}

OptionGroup
runOptions(PassJob& job)
{
  return {"Run",
          {threadsOption("the path does not depend on it", job.threads), switchOption("verbose", "print more", job.verbose),
           switchOption("quiet", "print only errors", job.quiet), switchOption("help", "print this text", job.help),
           switchOption("version", "print the version", job.version)}};
}
