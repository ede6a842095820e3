// SPDX-License-Identifier: BSD-3-Clause
#include "pass_options.h"
#include "program/holder_options.h"
#include "terminal/cutter_shape.h"

#include <pcl_spiral/common/impl/thread_limit.h>

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
  addOptions(group, {numberOption("feed", "F", "feed at the contact, mm/min; default 1000: --feed 2500", job.feed)});
  return group;
}

OptionGroup
motionOptions(PassJob& job)
{
  OptionGroup group{"Moves and axes of the tool", {}};
  addSettings(group, settingTable(static_cast<pcl_spiral::PassSettings&>(job)));
  return group;
}

OptionGroup
runOptions(PassJob& job)
{
  OptionGroup group{"Run", {}};
  addSettings(group, {pcl_spiral::threadsSetting(job.threads)});
  addOptions(group, {switchOption("verbose", "print more", job.verbose), switchOption("quiet", "print only errors", job.quiet),
                     switchOption("help", "print this text", job.help), switchOption("version", "print the version", job.version)});
  return group;
}
