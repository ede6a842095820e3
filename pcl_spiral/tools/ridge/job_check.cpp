// SPDX-License-Identifier: BSD-3-Clause
#include "job_check.h"

#include "passes/pass_check.h"
#include "program/program_check.h"
#include "terminal/idle_options.h"
#include "terminal/option_values.h"

#include "planning/pass_defaults.h"

#include <pcl_spiral/core/diagnostic.h>

#include <algorithm>
#include <filesystem>
#include <initializer_list>

using namespace pcl_spiral;

namespace {

/** \throw UsageError with \p remedy if one of \p options is given */
void
refuse(const Job& job, std::initializer_list<const char*> options, const Diagnostic& remedy)
{
  for (const char* option : options)
    if (isGiven(job, option))
      throw UsageError(Diagnostic("--", option, ": ", remedy));
}

/** Checks that both lines are given, or a scan with rough points. */
void
checkLines(const Job& job)
{
  const bool in_scan = isGiven(job, "through");
  if (in_scan) {
    if (job.scan.empty())
      throw UsageError("--through: no --scan is given; give the scan that holds the ridge");
    if (!job.rail.empty() || !job.generator.empty())
      throw UsageError(Diagnostic("--through: rail and generator are also given as files (", (job.rail.empty() ? job.generator : job.rail),
                                  "); leave out --through or the files"));
    requireOption(job.half_width > 0.0, "half-width", job.half_width,
                  "must be above 0 mm; give the width of the ridge from its crest to each side");
    refuse(job, {"measuring-error"}, "the lines are found in the scan, and so is the noise; leave it out");
    return;
  }
  refuse(job, {"half-width", "ring"}, "belongs to --through, a ridge in a scan; leave it out");
  if (job.rail.empty() || job.generator.empty())
    throw UsageError(
        job.rail.empty()
            ? Diagnostic("no rail is given; give two files, points along the ridge and points across it: rail.pcd generator.pcd (or "
                         "--scan with --through)")
            : Diagnostic("no generator is given; give a second file, points measured once across the ridge: ", job.rail, " generator.pcd"));
  std::error_code error;
  if (std::filesystem::equivalent(job.rail, job.generator, error))
    throw UsageError(Diagnostic(
        job.generator, ": rail and generator are the same file; give the file of points along the ridge first, then the file of points "
                       "across it"));
}

/** Exactly one option sets the distance between rows. */
void
checkRows(Job& job)
{
  RidgeRowSettings& s = job.rows;
  const int given = isGiven(job, "spot") + isGiven(job, "step-over") + isGiven(job, "scallop");
  if (given != 1)
    throw UsageError(Diagnostic(given == 0 ? "no option sets" : "more than one option sets",
                                " the distance between rows; give one of --spot, --step-over and --scallop"));
  if (isGiven(job, "spot"))
    requireOption(s.spot_size > 0.0, "spot", s.spot_size, "must be above 0 mm");
  if (isGiven(job, "step-over"))
    requireOption(s.step_over > 0.0, "step-over", s.step_over, "must be above 0 mm");
  if (!isGiven(job, "spot"))
    refuse(job, {"overlap"}, "belongs to --spot; leave it out");
  s.zigzag = !job.one_way;
}

void
checkBeam(Job& job)
{
  completeRidge({}, job, job.rows);
  if (isGiven(job, "tool-radius"))
    requireOption(job.cutter.radius > 0.0, "tool-radius", job.cutter.radius, "must be above 0 mm; for a beam leave it out");
  if (!job.scan.empty() && job.through.empty())
    throw UsageError(
        Diagnostic("--scan ", job.scan,
                   ": a beam uses only rail and generator; leave --scan out, give a cutter (--tool-radius), or give --through instead of "
                   "both files"));
  for (const std::string& output : job.outputs)
    if (isExchange(output) && extensionOf(output) != ".yaml")
      throw UsageError(
          Diagnostic("-o ", output, ": this format needs a cutter, and the tool is a beam; use .6d, .5d, .csv, .yaml or a program"));
}

void
checkCutter(Job& job)
{
  completeCutter(job);
  job.rows.scallop_height = job.scallop;
  completeRidge({false, false, isGiven(job, "tolerance")}, job, job.rows);
  checkTool(job);
  refuse(job, {"stand-off"}, "a cutter touches the surface; leave --stand-off or --tool-radius out");
  refuse(job, {"spot"}, "belongs to a beam; for a cutter give --step-over or --scallop");
  if (!isGiven(job, "scallop"))
    return;
  if (!isBall(job))
    throw UsageError("--scallop: ridge heights are known only for a ball; for this cutter give a --step-over");
  requireOption(job.scallop > 0.0 && job.scallop < job.cutter.radius, "scallop", job.scallop,
                "must be above 0 and below the tool radius, which is " + Diagnostic(job.cutter.radius) + " mm");
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
  requireUsed(idleSetting(askedNames(job.given), job, {false, !job.holder.empty()}));
  if (job.hasCutter())
    checkCutter(job);
  else
    checkBeam(job);
  if (job.scan.empty())
    refuse(job, {"leave-out-strays", "largest", "thin"}, "belongs to a --scan, and none is given; leave it out");
  requireOption(job.thinning >= 0.0, "thin", job.thinning, "must be above 0 mm, or 0 for none");
  checkMotion(job);
  checkOutputs(job, filesOf(job), {{"the rail", job.rail}, {"the generator", job.generator}, {"the scan", job.scan}}, {".html"});
  checkProgram(job.program, job.outputs, job.given);
}
