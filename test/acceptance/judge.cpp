// SPDX-License-Identifier: BSD-3-Clause
#include "cases.h"
#include "table.h"

#include "support/ideal_length.h"
#include "support/path_checks.h"
#include "support/removed_material.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace pcl_spiral::acceptance {

namespace {

/** Integral of dA / exact step-over for turns of unknown direction: the mean over the two principal directions. */
double
lengthOverPrincipal(const Job& job)
{
  return job.surface->region().integrate([&](const Eigen::Vector2d& u) {
    const auto [least, most] = job.surface->principalCurvatures(job.surface->lift(u));
    const double r = job.tool_radius, h = job.scallop_height;
    return job.surface->areaElement(u) * 0.5 * (1.0 / test::exactStepOver(r, h, least) + 1.0 / test::exactStepOver(r, h, most));
  });
}

void
judgePath(const Job& job, const Run& run, const test::CheckedPath& path, int threads, Table& table)
{
  const double step = test::exactStepOver(job.tool_radius, job.scallop_height, 0.0);
  const test::ToolpathReport f = test::checkPath(*job.surface, path, 10.0 * step, threads);
  if (job.deviation_rms > 0.0)
    table.atMost("deviation rms", f.deviation_rms, job.deviation_rms);
  else
    table.note("deviation rms", f.deviation_rms);
  if (job.deviation_p99 > 0.0)
    table.atMost("deviation p99", f.deviation_p99, job.deviation_p99);
  else
    table.note("deviation p99", f.deviation_p99);
  table.atMost("deviation max", f.deviation, job.deviation_max);
  table.note("normal error max", text(f.normal_error));
  table.atMost("largest gap against allowed step", f.gap, run.report.largest_allowed_step + 1e-4);
  if (job.turning > 0.0)
    table.atMost("largest turning", f.turning, job.turning, "deg");
  else
    table.note("largest turning", text(f.turning));
  table.note("contact farthest past the outline", text(f.beyond_rim));
  const double h20 = 20.0 * job.scallop_height; // a rim farther from the path than this counts as uncut
  table.atMost("outline farthest from the path", f.rim_missed, std::sqrt(2.0 * job.tool_radius * h20 - h20 * h20));
  table.atMost("crossings", static_cast<double>(f.crossings), 0.0, "");
  if (f.crossings > 0)
    table.note("  deepest crossing", text(f.crossing));
  const double ideal =
      job.length_ratio > 0.0 ? test::lengthOverLatitudes(*job.surface, job.tool_radius, job.scallop_height) : lengthOverPrincipal(job);
  if (job.length_ratio > 0.0)
    table.atMost("length / ideal length", f.length / ideal, job.length_ratio, "");
  else
    table.note("length / ideal length (mean)", f.length / ideal, "");
  table.holds("report agrees with the path",
              std::abs(run.report.path_length / f.length - 1.0) < 1e-5 && run.report.path_points == path.size() &&
                  std::abs(run.report.largest_gap - f.gap.value) < 1e-3,
              "length " + std::to_string(run.report.path_length) + " / " + std::to_string(f.length) + ", gap " +
                  std::to_string(run.report.largest_gap) + " / " + std::to_string(f.gap.value));
}

void
judgeMaterial(const Job& job, const test::CheckedPath& path, const Options& options, Table& table)
{
  test::RemovalSettings settings;
  settings.tool_radius = job.tool_radius;
  settings.scallop_height = job.scallop_height;
  settings.samples = job.samples;
  settings.seed = options.seed + 77;
  settings.threads = options.threads;
  const test::RemovalReport f = test::removedMaterial(*job.surface, path, settings);
  const double h = job.scallop_height, e = job.chord_error;
  table.note("band left out at the rim", f.band);
  table.note("stock p50 / p99 at the samples", std::to_string(f.stock.p50) + " / " + std::to_string(f.stock.p99));
  table.note("scallop p50 / p99", std::to_string(f.ridge.p50) + " / " + std::to_string(f.ridge.p99));
  const double none = 1e9;
  table.atMost("scallop p99.9", f.ridge.p999, job.scallop ? 1.02 * h + e : none);
  table.atMost("scallop max", f.ridge.max, job.scallop ? 1.03 * h + e : none);
  table.atMost("gouge max", std::max(0.0, f.gouge.value), job.scallop ? 1.1 * e + 0.002 : none);
  if (f.gouge.value > 1.1 * e + 0.002)
    table.note("  deepest gouge", text(f.gouge));
  table.atMost("uncut share", f.ridge.uncut, 0.0, "");
  table.atMost("uncut share within the band", f.rim.uncut, 0.0, "");
  table.note("stock max within the band", text(f.rim.max));
}

/** Checks that hold for every path on any surface. */
void
judgePoints(const Run& run, Table& table)
{
  std::size_t bad_normal = 0, bad_axis = 0, bad_order = 0;
  for (std::size_t i = 0; i < run.path.size(); ++i) {
    const ToolpathPoint& p = run.path[i];
    bad_normal += std::abs(p.getNormalVector3fMap().norm() - 1.0f) < 1e-5f ? 0 : 1;
    bad_axis += std::abs(p.getAxisVector3fMap().norm() - 1.0f) < 1e-5f ? 0 : 1;
    if (i > 0)
      bad_order += p.arc_length >= run.path[i - 1].arc_length && p.turn >= run.path[i - 1].turn ? 0 : 1;
  }
  table.atMost("normals and axes not of unit length", static_cast<double>(bad_normal + bad_axis), 0.0, "");
  table.atMost("steps back in arc length or turn", static_cast<double>(bad_order), 0.0, "");
}

} // namespace

int
judge(const Job& job, const Options& options)
{
  char title[160];
  std::snprintf(title, sizeof title, "%s: %zu points, seed %llu, R %g, scallop %g, chord %g, noise %g", job.name.c_str(), job.points,
                static_cast<unsigned long long>(options.seed), job.tool_radius, job.scallop_height, job.chord_error, job.noise);
  Table table(title);
  const Run result = run(job, test::toCloud(sampled(job, options.seed).points), options.threads);
  table.note("time", result.seconds, "s");
  for (const StageCost& stage : result.report.stages)
    table.note("  " + stage.name, stage.seconds, "s");
  for (const pcl_spiral::Diagnostic& warning : result.report.warnings)
    table.note("warning", warning.text());
  if (job.may_refuse && !result.status.ok()) {
    table.holds("refused with a reason", result.path.empty() && result.status.message().size() > 40, result.status.message());
    return table.broken();
  }
  table.holds("a path is made", result.status.ok() && result.path.size() > 2, result.status.message());
  if (result.path.size() < 3)
    return table.broken();
  table.note("path points", static_cast<double>(result.path.size()), "");
  table.note("turns", static_cast<double>(result.report.turns), "");
  table.note("radial lines", static_cast<double>(result.report.radial_lines.size()),
             result.report.harmonic_lines ? "harmonic" : "geodesic");
  table.atMost("boundaries other than true",
               std::abs(static_cast<double>(result.report.boundaries) - static_cast<double>(job.surface->outlines().size())), 0.0, "");
  const test::CheckedPath path = test::fromToolpath(result.path);
  judgePoints(result, table);
  judgePath(job, result, path, options.threads, table);
  judgeMaterial(job, path, options, table);
  return table.broken();
}

} // namespace pcl_spiral::acceptance
