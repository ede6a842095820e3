// SPDX-License-Identifier: BSD-3-Clause
// Paths judged by a second, exact cloud of the part, which the planner does not have: the distance of the path from the part,
// and the greatest error after simulated machining. Among them are the two parts of Wu et al. 2025 at full size; they
// publish 0.046 and 0.1215 mm (the first).
#include "cases.h"
#include "table.h"

#include "support/path_checks.h"

#include <pcl_spiral/verify/deviation_estimation.h>
#include <pcl_spiral/verify/material_removal.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

namespace pcl_spiral::acceptance {

namespace {

template <typename Judge>
void
prepare(Judge& judge, const Cloud::ConstPtr& reference, const Path::ConstPtr& path, const Job& job, int threads)
{
  judge.setInputCloud(reference);
  judge.setInputToolpath(path);
  judge.setChordError(job.chord_error);
  judge.setNumberOfThreads(threads);
}

} // namespace

int
judgeBySecondCloud(const Job& job, const Options& options)
{
  char title[160];
  std::snprintf(title, sizeof title, "%s: %zu points, seed %llu, R %g, scallop %g, chord %g, noise %g", job.name.c_str(), job.points,
                static_cast<unsigned long long>(options.seed), job.tool_radius, job.scallop_height, job.chord_error, job.noise);
  Table table(title);
  const Run result = run(job, test::toCloud(sampled(job, options.seed).points), options.threads);
  table.holds("a path is made", result.status.ok(), result.status.message());
  if (!result.status.ok())
    return table.broken();
  table.note("time", result.seconds, "s");
  table.note("path points", static_cast<double>(result.path.size()), "");
  table.note("path length", 1e-6 * result.report.path_length, "km");
  const test::ToolpathReport exact = test::checkPath(*job.surface, test::fromToolpath(result.path), 1.0, options.threads);
  table.note("deviation rms, by formula", exact.deviation_rms);
  table.atMost("deviation max, by formula", exact.deviation, job.deviation_max);

  const auto reference = test::toCloud(test::sampleUniform(*job.surface, job.points, options.seed + 5000).points);
  const auto path = pcl::make_shared<Path>(result.path);
  const auto from = std::chrono::steady_clock::now();
  pcl::PointCloud<pcl::PointXYZI> values;
  DeviationEstimation<pcl::PointXYZ> deviation;
  prepare(deviation, reference, path, job, options.threads);
  deviation.compute(values);
  table.holds("deviation is measured", deviation.getStatus().ok(), deviation.getStatus().message());
  MaterialRemoval<pcl::PointXYZ> removal;
  prepare(removal, reference, path, job, options.threads);
  removal.setReferenceSurface(deviation.getReferenceSurface());
  removal.setToolRadius(job.tool_radius);
  removal.setScallopHeight(job.scallop_height);
  removal.compute(values);
  table.holds("removed material is measured", removal.getStatus().ok(), removal.getStatus().message());
  if (!deviation.getStatus().ok() || !removal.getStatus().ok())
    return table.broken();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count();
  const DeviationReport& d = deviation.getReport();
  const RemovalReport& r = removal.getReport();
  const std::size_t samples = r.stock.samples + r.rim.samples;
  table.atMost("deviation max, by the second cloud", std::abs(d.max.value), job.deviation_max);
  table.note("beyond the outermost points", std::abs(d.rim_max.value));
  table.note("scallop p99.9", r.scallop.p999);
  table.note("scallop max", r.scallop.max.value);
  table.note("stock max at the rim", r.rim.max.value);
  table.note("gouge max", r.gouge.value);
  table.note("gouge beyond the outermost points", r.rim_gouge.value);
  const double machined = std::max({r.scallop.max.value, r.stock.max.value, r.rim.max.value, r.gouge.value});
  if (job.machined_max > 0.0)
    table.atMost("greatest error after machining", machined, job.machined_max);
  table.atMost("uncut points", static_cast<double>(r.stock.uncut + r.rim.uncut), 0.0, "of " + std::to_string(samples));
  table.note("efficiency", r.efficiency, "");
  if (job.judge_seconds > 0.0)
    table.atMost("time to judge", seconds, job.judge_seconds, "s");
  else
    table.note("time to judge", seconds, "s");
  return table.broken();
}

} // namespace pcl_spiral::acceptance
