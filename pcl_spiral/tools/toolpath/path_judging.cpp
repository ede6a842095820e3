// SPDX-License-Identifier: BSD-3-Clause
#include "path_judging.h"
#include "terminal/terminal.h"

#include "verify/limit_verdicts.h"
#include <pcl_spiral/io/file_error.h>

using namespace pcl_spiral;

bool
judgedByTheSameSurface(const SpiralSettings& settings)
{
  return settings.thinning == 0.0 && settings.outlier_neighbours == 0;
}

namespace {

Diagnostic
moreOf(std::size_t broken)
{
  return broken > 1 ? Diagnostic("; and ", broken - 1, " more") : Diagnostic();
}

void
judgeOne(const Job& job, Result& result)
{
  ProgressBar bar(job.quiet);
  const SpiralSettings& s = job.settings;
  JudgeSettings settings;
  settings.cutter = CutterShape::ball(s.tool_radius);
  settings.scallop_height = s.scallop_height;
  settings.chord_error = s.chord_error;
  settings.side = result.side;
  settings.part_at = result.part.part_at;
  settings.flip_normals = s.flip_normals;
  settings.clusters = judgedClusters(job.part);
  settings.threads = s.threads;
  settings.sample_spacing = job.sample_spacing;
  if (result.mesh)
    settings.mesh = result.mesh->mesh;
  else if (judgedByTheSameSurface(s))
    settings.surface = result.surface;
  std::shared_ptr<const ReferenceSurface> reference;
  Verification verification;
  const Status status = judgePath(
      result.scan.cloud, result.path, settings, [&bar](double share, const std::string& stage) { return bar.update(share, stage); },
      reference, verification, result.heights);
  bar.clear();
  if (cancelled())
    throw Cancelled();
  if (!status.ok())
    throw FileError(job.scan, Diagnostic("the path was made but could not be checked: ", status.diagnostic()));
  if (!settings.surface)
    result.report.passes += reference->scanned().counts().passes;
  verification.broken = brokenLimits(job.limits, verification);
  verification.unproven = unprovenLimits(job.limits, verification);
  if (!verification.broken.empty())
    throw FileError(job.scan, Diagnostic("the path was made, but a limit is broken: ", verification.broken.front(),
                                         moreOf(verification.broken.size())));
  if (!job.stock.empty())
    result.left = stockMesh(*reference, result.heights.stock);
  result.verification = std::move(verification);
}

} // namespace

void
judge(const Job& job, Result& result)
{
  if (!job.verify)
    return;
  if (result.regions.empty())
    return judgeOne(job, result);
  for (Result& region : result.regions) {
    const int before = region.report.passes;
    inRegion(region.region, [&] { judgeOne(job, region); });
    result.report.passes += region.report.passes - before;
    for (const auto values : {&Heights::deviation, &Heights::scallop})
      (result.heights.*values).insert((result.heights.*values).end(), (region.heights.*values).begin(), (region.heights.*values).end());
  }
}
