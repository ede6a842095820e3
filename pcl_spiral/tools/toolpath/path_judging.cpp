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

/** Judges one region of \p plan, or all of it. */
void
judgeOne(const Job& job, const ScanSide& side, SpiralPlan& plan, Judged& judged)
{
  ProgressBar bar(job.quiet);
  const SpiralSettings& s = job.settings;
  JudgeSettings settings;
  settings.cutter = CutterShape::ball(s.tool_radius);
  settings.scallop_height = s.scallop_height;
  settings.chord_error = s.chord_error;
  settings.normals = plan.normals;
  settings.view_point = side.view_point;
  settings.part_at = plan.settings.part_at;
  settings.flip_normals = s.flip_normals;
  settings.clusters = judgedClusters(job.part);
  settings.threads = s.threads;
  settings.sample_spacing = job.sample_spacing;
  if (plan.mesh)
    settings.mesh = plan.mesh->mesh;
  else if (judgedByTheSameSurface(s))
    settings.surface = plan.surface;
  std::shared_ptr<const ReferenceSurface> reference;
  Verification verification;
  const Status status = judgePath(
      plan.cloud, plan.path, settings, [&bar](double share, const std::string& stage) { return bar.update(share, stage); }, reference,
      verification, judged.heights);
  bar.clear();
  if (cancelled())
    throw Cancelled();
  if (!status.ok())
    throw FileError(job.scan, Diagnostic("the path was made but could not be checked: ", status.diagnostic()));
  if (!settings.surface)
    plan.report.passes += reference->scanned().report().passes;
  verification.broken = brokenLimits(job.limits, verification);
  verification.unproven = unprovenLimits(job.limits, verification);
  if (!verification.broken.empty())
    throw FileError(job.scan, Diagnostic("the path was made, but a limit is broken: ", verification.broken.front(),
                                         moreOf(verification.broken.size())));
  if (!job.stock.empty())
    judged.left = stockMesh(*reference, judged.heights.stock);
  judged.verification = std::move(verification);
}

} // namespace

void
judge(const Job& job, Result& result)
{
  if (!job.verify)
    return;
  if (result.regions.empty())
    return judgeOne(job, result.side, result.plan, result.judged);
  for (std::size_t k = 0; k < result.regions.size(); ++k) {
    SpiralPlan& region = result.plan.regions[k];
    const int before = region.report.passes;
    inRegion(region.region, [&] { judgeOne(job, result.side, region, result.regions[k]); });
    result.plan.report.passes += region.report.passes - before;
    append(result.regions[k].left, result.judged.left);
    const Heights& own = result.regions[k].heights;
    for (const auto values : {&Heights::deviation, &Heights::scallop}) {
      std::vector<float>& all = result.judged.heights.*values;
      all.insert(all.end(), (own.*values).begin(), (own.*values).end());
    }
  }
}
