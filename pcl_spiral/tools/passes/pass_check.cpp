// SPDX-License-Identifier: BSD-3-Clause
#include "pass_check.h"

#include "pass_files.h"
#include "program/holder_options.h"
#include "program/program_check.h"
#include "terminal/cutter_shape.h"
#include "terminal/file_names.h"
#include "terminal/option_values.h"

#include "planning/pass_defaults.h"
#include <pcl_spiral/core/diagnostic.h>

#include <algorithm>

using namespace pcl_spiral;

bool
isBall(const PassJob& job)
{
  return isBallEnd(job.cutter);
}

void
completeCutter(PassJob& job)
{
  completeCutter(isGiven(job, "corner-radius"), job.cutter);
  checkHolder(job.holder, job.holder_clearance, job.cutter.flank_length);
}

void
checkTool(const PassJob& job)
{
  if (isGiven(job, "pole-cone") && !isBall(job))
    throw UsageError("--pole-cone: axes are blended only for ball cutters, because the ball's centre does not move; leave it out");
  requireOption(job.tolerance <= std::max(least_tolerance, 0.1001 * job.cutter.radius), "tolerance", job.tolerance,
                Diagnostic("must be at most a tenth of the tool radius of ", job.cutter.radius, " mm, such as ",
                           std::max(least_tolerance, 0.01 * job.cutter.radius)));
}

void
checkMotion(const PassJob& job)
{
  requireOption(job.feed > 0.0, "feed", job.feed, "must be above 0 mm/min");
}

void
checkOutputs(const PassJob& job, const std::vector<std::string>& files, std::vector<InputName> inputs,
             const std::vector<std::string>& more_kinds)
{
  if (job.outputs.empty())
    throw UsageError("no output is given; give at least one, such as -o part.csv");
  for (const std::string& file : job.outputs) {
    const std::string extension = extensionOf(file);
    if (!isPassFile(file) && std::find(more_kinds.begin(), more_kinds.end(), extension) == more_kinds.end()) {
      std::string known = ".csv .pcd .ply .vtp .ngc .nc .mpf .h .apt .cls .yaml .6d .5d .json ";
      for (const std::string& kind : more_kinds)
        known += kind + " ";
      throw UsageError(Diagnostic("-o ", file, ": extension '", extension, "' is not known; use ", known, "or .png"));
    }
    if (!isBall(job) && (extension == ".pcd" || extension == ".ply"))
      throw UsageError(Diagnostic("-o ", file,
                                  ": this format holds contacts, and only for a ball do they give the tips; write the path of this "
                                  "tool as .csv, .vtp, .6d or a program"));
  }
  inputs.push_back({"the machine's file", job.program.machine_file});
  inputs.push_back({"the job file", job.config_file});
  for (const InputName& polygon : polygonFiles(job.choice))
    inputs.push_back(polygon);
  for (auto file = files.begin(); file != files.end(); ++file) {
    requireNoInput(*file, inputs);
    if (std::find(files.begin(), file, *file) != file)
      throw UsageError(Diagnostic("-o ", *file, ": is given twice",
                                  (std::count(job.outputs.begin(), job.outputs.end(), *file) < 2
                                       ? ", because it is written with another picture; rename one"
                                       : "")));
  }
}
