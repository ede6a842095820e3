// SPDX-License-Identifier: BSD-3-Clause
#include "job_check.h"
#include "passes/pass_check.h"
#include "program/program_check.h"
#include "terminal/file_names.h"
#include "terminal/idle_options.h"
#include "terminal/option_values.h"

#include "io/setting_names.h"
#include "planning/pass_defaults.h"
#include <pcl_spiral/common/impl/thread_limit.h>
#include <pcl_spiral/core/cutter_profile.h>
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/io/toolpath_writer.h>

#include <algorithm>
#include <cmath>
#include <optional>

using namespace pcl_spiral;

namespace {

/** Refuses options that the chosen path does not use. */
void
requireMeant(const Job& job)
{
  requireUsed(idleSetting(askedNames(job.given), job.drive, job, {job.mesh, !job.holder.empty(), !job.no_gouge_check, false}));
  if (isGiven(job, "link") && job.one_way)
    throw UsageError("--link: with --one-way each row begins far from the end of the row before; leave --one-way or --link out");
  if (isGiven(job, "accept-collisions") && job.holder.empty() && !hasLeads(job.program, job.outputs))
    throw UsageError("--accept-collisions: without a --holder, or a program, CLDATA or robot frames as output, it does nothing; leave it "
                     "out");
}

/** Checks --scallop and --step-over, and the rows that keep the scallop. */
void
checkScallop(const Job& job)
{
  const bool kept = job.drive.rows == DriveRows::Kept;
  if (isGiven(job, "step-over") && isGiven(job, "scallop"))
    throw UsageError("--step-over and --scallop are both given; one follows from the other, so leave one out");
  if (kept && !isGiven(job, "scallop"))
    throw UsageError("--rows kept: no --scallop is given; give the scallop height that the rows must keep, in mm, such as "
                     "--scallop 0.01");
  if (kept && job.mesh && !isBall(job))
    throw UsageError("--rows kept: on a --mesh only a ball keeps rows to a scallop height; leave --corner-radius and --flank-angle out, "
                     "leave --mesh out, or use --rows even");
  if (!isGiven(job, "scallop"))
    return;
  requireOption(job.drive.scallop_height > 0.0 && job.drive.scallop_height < job.cutter.radius, "scallop", job.drive.scallop_height,
                "must be above 0 and below the tool radius, which is " + Diagnostic(job.cutter.radius) + " mm");
  if (!stepForScallop(CutterProfile(job.cutter), job.drive.scallop_height))
    throw UsageError(
        Diagnostic("--scallop ", job.drive.scallop_height, ": no step-over gives this height with this cutter; give a --step-over"));
}

/** Refuses what a mesh, or passes without the check of gouges, cannot have. */
void
requireMeshMeant(const Job& job)
{
  const DriveKind kind = job.drive.kind;
  if (job.mesh && kind == DriveKind::BoundaryOffset)
    throw UsageError(Diagnostic("--drive ", choiceName(kind),
                                ": offsets run over the points of a scan, not over a mesh; use --drive planes, or leave "
                                "--mesh out: then the vertices are a scan"));
  if (job.no_gouge_check && kind != DriveKind::Planes)
    throw UsageError(Diagnostic("--no-gouge-check: with --drive ", choiceName(kind),
                                " the places are not on the mesh until the cutter moves "
                                "down to it; leave it out"));
  if (job.no_gouge_check && !job.holder.empty())
    throw UsageError("--no-gouge-check: a --holder is given, and only that check looks at the holder; leave one of them out");
}

void
completePath(Job& job)
{
  requireMeant(job);
  requireMeshMeant(job);
  job.flip_scan = !job.mesh && job.mesh_settings.flip;
  DriveSettings& d = job.drive;
  d.zigzag = !job.one_way;
  completeDrive({isGiven(job, "rows"), isGiven(job, "point-spacing")}, job, job.mesh, d);
  checkScallop(job);
  const bool is_curve = d.kind == DriveKind::Curve;
  if (!is_curve && !isGiven(job, "step-over") && !isGiven(job, "scallop"))
    throw UsageError("no --step-over is given; give the largest distance between neighbouring passes in mm, such as "
                     "--step-over 1, or --scallop");
  if (is_curve && job.curve_file.empty())
    throw UsageError("--drive curve: no --curve is given; give a file with the points of the curve in order");
  if (is_curve && job.regions.several())
    throw UsageError("--drive curve: the same curve would be followed over each region; give one region, or --drive planes");
  if (job.column_axis && !(job.column_axis->norm() > 0.0))
    throw UsageError("--column-axis: three zeros are no direction; give one such as 0,0,1");
  if (is_curve)
    return; // the points are read later
  if (const Status status = checkSettings(d); !status.ok())
    throw UsageError(status.diagnostic());
}

} // namespace

std::vector<std::string>
filesOf(const Job& job)
{
  std::vector<std::string> files;
  for (const std::string& output : job.outputs) {
    files.push_back(output);
    if (extensionOf(output) == ".png" && hasProgram(job.program, job.outputs))
      files.push_back(besideName(output, "_rotary"));
  }
  return files;
}

void
completeJob(Job& job)
{
  if (job.scan.empty())
    throw UsageError("no scan is given; give one, such as part.pcd");
  job.part = job.scan;
  requireOption(job.thinning >= 0.0, "thin", job.thinning, "must be above 0 mm, or 0 for none");
  if (!isGiven(job, "tool-radius"))
    throw UsageError("no --tool-radius is given; give the cutter's radius at the upper end of its flank, in mm, such as "
                     "--tool-radius 6");
  completeCutter(job);
  completePath(job);
  checkTool(job);
  std::vector<InputName> inputs{{"the scan", job.scan}, {"the curve", job.curve_file}, {"the raw scan", job.raw_scan}};
  for (const std::string& file : job.regions.polygons)
    inputs.push_back({"a region", file});
  checkOutputs(job, filesOf(job), inputs, {".html"});
  checkProgram(job.program, job.outputs, job.given);
}
