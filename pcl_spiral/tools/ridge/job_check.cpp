// SPDX-License-Identifier: BSD-3-Clause
#include "job_check.h"

#include "passes/pass_check.h"
#include "program/program_check.h"
#include "terminal/option_values.h"

#include <pcl_spiral/common/impl/message.h>

#include <algorithm>
#include <filesystem>
#include <initializer_list>

using namespace pcl_spiral;

namespace {

/** \throw UsageError where one of \p options is given that \p remedy is about */
void
refuse(const Job& job, std::initializer_list<const char*> options, const std::string& remedy)
{
  for (const char* option : options)
    if (isGiven(job, option))
      throw UsageError(std::string("--") + option + ": " + remedy);
}

/** Both lines, or a scan and where in it. */
void
checkLines(const Job& job)
{
  const bool in_scan = isGiven(job, "through");
  if (in_scan) {
    if (job.scan.empty())
      throw UsageError("--through: no --scan is given in which the ridge is to be found");
    if (!job.rail.empty() || !job.generator.empty())
      throw UsageError("--through: rail and generator are given as files, too (" + (job.rail.empty() ? job.generator : job.rail) +
                       "); leave the one or the other out");
    requireOption(job.half_width > 0.0, "half-width", job.half_width,
                  "must be above 0 mm: how far the ridge goes from its crest to either side");
    refuse(job, {"measuring-error"}, "lines are found in the scan; its noise is found, too; leave it out");
    return;
  }
  refuse(job, {"half-width", "ring"}, "belongs to --through, the points of a ridge in a scan; leave it out");
  if (job.rail.empty() || job.generator.empty())
    throw UsageError(job.rail.empty()
                         ? "no rail is named; give two files, points along the ridge and points across it: rail.pcd generator.pcd (or "
                           "--scan with --through)"
                         : "no generator is named; give a second file, points measured once across the ridge: " + job.rail +
                               " generator.pcd");
  std::error_code error;
  if (std::filesystem::equivalent(job.rail, job.generator, error))
    throw UsageError(job.generator +
                     ": rail and generator are the same file; give the points measured along the ridge first, and those measured "
                     "across it second");
}

/** One tells how far rows are apart. */
void
checkRows(Job& job)
{
  RidgeRowSettings& s = job.rows;
  const int told = isGiven(job, "spot") + isGiven(job, "step-over") + isGiven(job, "scallop");
  if (told != 1)
    throw UsageError(std::string(told == 0 ? "nothing says" : "more than one option says") +
                     " how far rows are apart; give one of --spot, --step-over and --scallop");
  if (isGiven(job, "spot"))
    requireOption(s.spot_size > 0.0, "spot", s.spot_size, "must be above 0 mm");
  if (isGiven(job, "step-over"))
    requireOption(s.step_over > 0.0, "step-over", s.step_over, "must be above 0 mm");
  requireOption(s.overlap >= 0.0 && s.overlap < 1.0, "overlap", s.overlap, "must be 0 or more and below 1, such as 0.25");
  if (!isGiven(job, "spot"))
    refuse(job, {"overlap"}, "belongs to --spot; leave it out");
  requireOption(s.stand_off >= 0.0, "stand-off", s.stand_off,
                "must not be below 0 mm; for the other side of the ridge give --flip-normals");
  requireOption(s.point_spacing > 0.0, "point-spacing", s.point_spacing, "must be above 0 mm");
  requireOption(s.run_in >= 0.0, "run-in", s.run_in, "must not be below 0 mm");
  requireOption(s.run_out >= 0.0, "run-out", s.run_out, "must not be below 0 mm");
  s.zigzag = !job.one_way;
}

void
checkBeam(Job& job)
{
  requireOption(job.tolerance > 0.0, "tolerance", job.tolerance, "must be above 0 mm, such as 0.01");
  job.rows.chord_error = job.tolerance;
  refuse(job, {"corner-radius", "flank-length", "flank-angle", "holder", "holder-clearance", "accept-collisions", "scallop", "pole-cone"},
         "belongs to a cutter, and no --tool-radius is given; give it, or leave this out: then the tool is a beam");
  if (isGiven(job, "tool-radius"))
    requireOption(job.cutter.radius > 0.0, "tool-radius", job.cutter.radius, "must be above 0 mm; for a beam leave it out");
  if (!job.scan.empty() && job.through.empty())
    throw UsageError("--scan " + job.scan +
                     ": a beam is led by rail and generator alone; give a cutter (--tool-radius), or in place of both "
                     "files --through");
  for (const std::string& output : job.outputs)
    if (isExchange(output))
      throw UsageError("-o " + output + ": this format describes a cutter, and a beam has none; use .6d, .5d, .csv or a program");
}

void
checkCutter(Job& job)
{
  completeCutter(job);
  if (isGiven(job, "scallop") && !isGiven(job, "tolerance"))
    job.tolerance = std::min(job.tolerance, 0.5 * job.scallop);
  checkTool(job);
  job.rows.chord_error = 0.5 * job.tolerance; // half is for the moves between locations
  refuse(job, {"stand-off"}, "a cutter touches the surface; leave --stand-off or --tool-radius out");
  refuse(job, {"spot"}, "is a beam's; give a --step-over or --scallop for a cutter");
  if (!isGiven(job, "scallop"))
    return;
  if (!isBall(job))
    throw UsageError("--scallop: ridges between rows are known for a ball alone; give this cutter a --step-over");
  requireOption(job.scallop > 0.0 && job.scallop < job.cutter.radius, "scallop", job.scallop,
                "must lie above 0 and below the tool radius, which is " + textOf(job.cutter.radius) + " mm");
  job.rows.tool_radius = job.cutter.radius;
  job.rows.scallop_height = job.scallop;
}

} // namespace

std::vector<std::string>
filesOf(const Job& job)
{
  std::vector<std::string> files;
  for (const std::string& output : job.outputs) {
    files.push_back(output);
    if (extensionOf(output) != ".png")
      continue;
    for (const char* suffix : {"_lines", "_normals"})
      files.push_back(besideName(output, suffix));
    if (hasProgram(job.program, job.outputs))
      files.push_back(besideName(output, "_rotary"));
  }
  return files;
}

void
completeJob(Job& job)
{
  checkLines(job);
  job.part = job.rail.empty() ? job.scan : job.rail;
  checkRows(job);
  if (job.hasCutter())
    checkCutter(job);
  else
    checkBeam(job);
  if (job.scan.empty())
    refuse(job, {"leave-out-strays", "largest", "thin"}, "belongs to a --scan, and none is given; leave it out");
  requireOption(job.thinning >= 0.0, "thin", job.thinning, "must be above 0 mm, or 0 for none");
  checkMotion(job);
  checkOutputs(job, filesOf(job), {{"the rail", job.rail}, {"the generator", job.generator}, {"the scan", job.scan}});
  checkProgram(job.program, job.outputs, job.given);
}
