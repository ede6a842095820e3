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

OptionGroup
cutterOptions(PassJob& job, const std::string& need)
{
  OptionGroup group{"Cutter (mm, degrees): tapered bull-nose and its special cases",
                    cutterShapeOptions("radius at the upper end of the flank; " + need + ": --tool-radius 6", job.cutter)};
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
  OptionGroup group{"Run", {switchOption("verbose", "print more", job.verbose)}};
  addOptions(group, runOptions(job, job.threads).options);
  return group;
}
