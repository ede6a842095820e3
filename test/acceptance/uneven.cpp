// SPDX-License-Identifier: BSD-3-Clause
// Correct but difficult scans of exact parts, each compared with a clean scan: as many points as the density of its
// sparsest area gives, spread evenly, with the same noise.
#include "cases.h"
#include "outline_distance.h"
#include "table.h"

#include "support/path_checks.h"

#include <pcl_spiral/verify/impl/turn_wobble.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace pcl_spiral::acceptance {

namespace {

using test::SurfacePtr;

/** One scan, and the spacing of a clean scan of the same quality. */
struct Scan {
  std::string name;
  std::vector<Eigen::Vector3d> points;
  double coarse;
  double noise = 0.0;
};

Job
part(const std::string& name, SurfacePtr surface)
{
  Job j;
  j.name = name;
  j.surface = std::move(surface);
  j.tool_radius = 10.0;
  j.scallop_height = 0.05;
  j.chord_error = 0.005;
  return j;
}

Job
dome()
{
  return part("dome", test::spheroidCap(90.0, 50.0));
}

Job
plate()
{
  return part("plate", test::flat(test::Region({test::rectangle(110.0, 90.0), test::circle({10.0, 5.0}, 18.0)})));
}

std::size_t
countAt(const test::AnalyticSurface& surface, double spacing)
{
  return static_cast<std::size_t>(surface.area() / (spacing * spacing));
}

/** Points \p coarse apart where \p density, a share of the largest density, is one \p ratio-th. */
test::Sampled
sampleByDensity(const test::AnalyticSurface& surface, double coarse, double ratio, std::uint64_t seed,
                const std::function<double(const Eigen::Vector3d&)>& density)
{
  test::Random random(seed + 31);
  const test::Sampled all =
      test::sampleUniform(surface, static_cast<std::size_t>(ratio * static_cast<double>(countAt(surface, coarse))), seed);
  test::Sampled kept;
  for (std::size_t i = 0; i < all.points.size(); ++i)
    if (random.uniform() < density(all.points[i])) {
      kept.points.push_back(all.points[i]);
      kept.normals.push_back(all.normals[i]);
    }
  return kept;
}

/** Share of the largest density; its logarithm falls linearly to one \p ratio-th across the part. */
std::function<double(const Eigen::Vector3d&)>
fading(const test::AnalyticSurface& surface, double ratio)
{
  const double low = surface.region().lower().x(), high = surface.region().upper().x();
  return [=](const Eigen::Vector3d& p) { return std::pow(ratio, -std::clamp((p.x() - low) / (high - low), 0.0, 1.0)); };
}

std::function<double(const Eigen::Vector3d&)>
stepping(double ratio)
{
  return [=](const Eigen::Vector3d& p) { return p.x() + 0.3 * p.y() < 8.0 ? 1.0 : 1.0 / ratio; };
}

/** Two passes over most of the part each, \p offset apart along the normal. */
std::vector<Eigen::Vector3d>
twoPasses(const test::AnalyticSurface& surface, const test::Sampled& first, const test::Sampled& second, double offset)
{
  const double low = surface.region().lower().x(), high = surface.region().upper().x(), width = high - low;
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < first.points.size(); ++i)
    if (first.points[i].x() < high - 0.35 * width)
      points.push_back(first.points[i] - 0.5 * offset * first.normals[i]);
  for (std::size_t i = 0; i < second.points.size(); ++i)
    if (second.points[i].x() > low + 0.35 * width)
      points.push_back(second.points[i] + 0.5 * offset * second.normals[i]);
  return points;
}

/** Adds \p share of outliers: half within \p near of the surface, half anywhere in a box
 *  that is \p near larger on all sides. */
void
addOutliers(const test::AnalyticSurface& surface, double share, double near, std::uint64_t seed, std::vector<Eigen::Vector3d>& points)
{
  test::Random random(seed + 77);
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : points)
    box.extend(p);
  box.min().array() -= near;
  box.max().array() += near;
  const auto count = static_cast<std::size_t>(share * static_cast<double>(points.size()));
  const test::Sampled off = test::sampleUniform(surface, count, seed + 78);
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d anywhere(random.uniform(), random.uniform(), random.uniform());
    points.push_back(i % 2 ? Eigen::Vector3d(off.points[i] + near * random.uniform(-1.0, 1.0) * off.normals[i])
                           : Eigen::Vector3d(box.min() + anywhere.cwiseProduct(box.sizes())));
  }
}

struct UnevenRun {
  Run run;
  test::ToolpathReport figures;
};

UnevenRun
unevenRun(const Job& job, const std::vector<Eigen::Vector3d>& points, const Options& options)
{
  UnevenRun outcome;
  outcome.run = run(job, test::toCloud(points), options.threads);
  if (outcome.run.status.ok())
    outcome.figures = test::checkPath(*job.surface, test::fromToolpath(outcome.run.path), 20.0, options.threads);
  return outcome;
}

void
judgeLoopsOf(const Run& run, const std::vector<Polyline>& outlines, double coarse, Table& table)
{
  std::size_t rims = 0;
  for (const BoundaryLoop& loop : run.report.loops)
    rims += loop.type != LoopType::ScanGap;
  table.atMost("  loops too many or too few", std::abs(static_cast<double>(run.report.loops.size()) - static_cast<double>(outlines.size())),
               0.0, "");
  for (const Polyline& outline : outlines) {
    test::Place best;
    best.value = 1e9;
    for (const BoundaryLoop& loop : run.report.loops) {
      const test::Place p = hausdorff(outline, loop.curve, 0.1 * coarse);
      best = p.value < best.value ? p : best;
    }
    best.value /= coarse;
    table.atMost("  outline off where it should be", best, 1.5, "spacings");
  }
}

/** \p outlines: the correct loops. */
void
judgeScan(const Job& job, const Scan& scan, const std::vector<Polyline>& outlines, const Options& options, Table& table)
{
  test::Sampled even = test::sampleUniform(*job.surface, countAt(*job.surface, scan.coarse), options.seed + 500);
  if (scan.noise > 0.0)
    test::addNoise(even, scan.noise, options.seed + 501);
  const UnevenRun clean = unevenRun(job, even.points, options), ugly = unevenRun(job, scan.points, options);
  table.holds(job.name + ", " + scan.name + ": a path is made", clean.run.status.ok() && ugly.run.status.ok(),
              clean.run.status.message() + ugly.run.status.message());
  table.note("  time, clean and ugly", std::to_string(clean.run.seconds) + " / " + std::to_string(ugly.run.seconds));
  for (const pcl_spiral::Diagnostic& warning : ugly.run.report.warnings)
    table.note("  warning", warning.text());
  if (!ugly.run.status.ok() || !clean.run.status.ok())
    return;
  table.note("  points, used of", std::to_string(ugly.run.report.used_points) + " / " + std::to_string(scan.points.size()));
  judgeLoopsOf(ugly.run, outlines, scan.coarse, table);
  table.note("  clean: deviation max", std::abs(clean.figures.deviation.value));
  table.note("  clean: deviation rms", clean.figures.deviation_rms);
  test::Place worst = ugly.figures.deviation;
  worst.value = std::abs(worst.value);
  table.atMost("  deviation max", worst, 2.0 * std::abs(clean.figures.deviation.value) + 1e-4);
  table.atMost("  deviation rms", ugly.figures.deviation_rms, 2.0 * clean.figures.deviation_rms + 1e-5);
  table.atMost("  crossings", static_cast<double>(ugly.figures.crossings), 0.0, "");
}

} // namespace

int
judgeLines(const Options& options)
{
  Table table("lines: points ten times closer on scan lines than the lines stand apart");
  for (const Job& job : {dome(), plate()}) {
    const test::AnalyticSurface& surface = *job.surface;
    judgeScan(job, {"jittered", test::sampleScanLines(surface, 0.2, 2.0, options.seed, 0.4).points, 2.0}, surface.outlines(), options,
              table);
    judgeScan(job, {"straight", test::sampleScanLines(surface, 0.2, 2.0, options.seed, 0.0).points, 2.0}, surface.outlines(), options,
              table);
    test::Sampled noisy = test::sampleScanLines(surface, 0.2, 2.0, options.seed, 0.1);
    test::addNoise(noisy, 0.02, options.seed);
    judgeScan(job, {"noisy", noisy.points, 2.0, 0.02}, surface.outlines(), options, table);
  }
  return table.broken();
}

int
judgeUneven(const Options& options)
{
  Table table("uneven: density changing over the part");
  for (const Job& job : {dome(), plate()}) {
    const test::AnalyticSurface& surface = *job.surface;
    for (const double ratio : job.name == "plate" ? std::vector<double>{10.0, 100.0} : std::vector<double>{10.0}) {
      const std::string name = std::to_string(static_cast<int>(ratio)) + ":1";
      judgeScan(job, {"fading " + name, sampleByDensity(surface, 2.0, ratio, options.seed, fading(surface, ratio)).points, 2.0},
                surface.outlines(), options, table);
      judgeScan(job, {"step " + name, sampleByDensity(surface, 2.0, ratio, options.seed, stepping(ratio)).points, 2.0}, surface.outlines(),
                options, table);
    }
  }
  return table.broken();
}

int
judgePasses(const Options& options)
{
  Table table("passes: two overlapping passes 0.02 mm apart");
  for (const Job& job : {dome(), plate()}) {
    const test::AnalyticSurface& surface = *job.surface;
    const std::size_t count = countAt(surface, 2.0);
    test::Sampled a = test::sampleUniform(surface, count, options.seed), b = test::sampleUniform(surface, count, options.seed + 1);
    if (job.name == "plate") {
      judgeScan(job,
                {"scan lines",
                 twoPasses(surface, test::sampleScanLines(surface, 0.2, 2.0, options.seed, 0.1),
                           test::sampleScanLines(surface, 0.2, 2.0, options.seed + 1, 0.1), 0.02),
                 2.0, 0.01},
                surface.outlines(), options, table);
    }
    judgeScan(job, {"without noise", twoPasses(surface, a, b, 0.02), 2.0, 0.01}, surface.outlines(), options, table);
    judgeScan(job, {"same points", twoPasses(surface, a, a, 0.02), 2.0, 0.01}, surface.outlines(), options, table);
    test::addNoise(a, 0.02, options.seed + 2);
    test::addNoise(b, 0.02, options.seed + 3);
    judgeScan(job, {"with noise", twoPasses(surface, a, b, 0.02), 2.0, 0.02}, surface.outlines(), options, table);
  }
  return table.broken();
}

int
judgeOutliers(const Options& options)
{
  constexpr double noise = 0.02;
  Table table("outliers: two in a hundred points false");
  for (const Job& job : {dome(), plate()}) {
    const test::AnalyticSurface& surface = *job.surface;
    const auto judge = [&](const std::string& name, test::Sampled scan) {
      test::addNoise(scan, noise, options.seed + 2);
      std::vector<Eigen::Vector3d> with_outliers = scan.points;
      addOutliers(surface, 0.02, 20.0, options.seed, with_outliers);
      std::vector<Polyline> outlines; // a random scan has no point at a corner
      for (const BoundaryLoop& loop : unevenRun(job, scan.points, options).run.report.loops)
        outlines.push_back(loop.curve);
      judgeScan(job, {name, with_outliers, 2.0, noise}, outlines, options, table);
    };
    judge("evenly spread", test::sampleUniform(surface, countAt(surface, 2.0), options.seed));
    judge("scan lines", test::sampleScanLines(surface, 0.2, 2.0, options.seed, 0.1));
    judge("density step", sampleByDensity(surface, 2.0, 10.0, options.seed, stepping(10.0)));
  }
  return table.broken();
}

int
judgeNoise(const Options& options)
{
  constexpr double spacing = 2.0;
  Table table("noise: a tenth of the spacing, and how much of it is left in the path");
  for (const Job& job : {dome(), plate()}) {
    const double sigma = 0.1 * spacing;
    test::Sampled scan = test::sampleUniform(*job.surface, countAt(*job.surface, spacing), options.seed);
    test::addNoise(scan, sigma, options.seed + 1);
    const UnevenRun outcome = unevenRun(job, scan.points, options);
    table.holds(job.name + ": a path is made", outcome.run.status.ok(), outcome.run.status.message());
    if (!outcome.run.status.ok())
      continue;
    CutterPath path;
    const auto toolpath = pcl::make_shared<Path>(outcome.run.path);
    table.holds("  it can be read", readCutterPath(toolpath, path).ok());
    std::vector<float> deviation;
    for (const Eigen::Vector3d& p : path.contacts)
      deviation.push_back(static_cast<float>(job.surface->signedDistance(p)));
    const TurnWobble wobble = turnWobble(path, deviation);
    table.note("  neighbours in one fit", outcome.run.report.projection_neighbours, "");
    table.atMost("  noise found off sigma", std::abs(outcome.run.report.noise - sigma), 0.1 * sigma);
    table.atMost("  deviation rms", outcome.figures.deviation_rms, sigma / 3.0);
    table.atMost("  wobble from turn to turn, rms", wobble.rms, sigma / 20.0);
    table.atMost("  wobble from turn to turn, largest", std::abs(wobble.max.value), sigma / 2.0);
  }
  return table.broken();
}

} // namespace pcl_spiral::acceptance
