// SPDX-License-Identifier: BSD-3-Clause
#include "cases.h"
#include "path_match.h"
#include "table.h"

#include <cmath>

namespace pcl_spiral::acceptance {

namespace {

void
comparePaths(const std::string& what, const Path& expected, const Run& other, const Eigen::Affine3d& back, Table& table)
{
  table.holds(what + ": a path is made", other.status.ok(), other.status.message());
  if (other.path.empty() || expected.empty())
    return;
  const PathMatch match = matched(mapped(other.path, back), expected);
  table.note(what + ": points", static_cast<double>(other.path.size()), "");
  table.atMost(what + ": off the first path", match.off, 1e-3);
  table.atMost(what + ": first path off it", match.missed, 1e-3);
  table.atMost(what + ": start", match.start, 1e-3);
  table.atMost(what + ": end", match.end, 1e-3);
}

/** The job on its points under a similarity: all lengths are scaled with them, and on a mirrored part the
 * sense is opposite. */
Run
runMapped(const Job& job, const std::vector<Eigen::Vector3d>& points, const Eigen::Affine3d& map, const Eigen::Vector3d& view,
          const Eigen::Vector3d& start, int threads)
{
  const double determinant = map.linear().determinant(), scale = std::cbrt(std::abs(determinant));
  Job mapped = job;
  for (double* length : {&mapped.tool_radius, &mapped.scallop_height, &mapped.chord_error})
    *length *= scale;
  std::vector<Eigen::Vector3d> mapped_points;
  for (const Eigen::Vector3d& p : points)
    mapped_points.push_back(map * p);
  const Eigen::Vector3d mapped_view = map * view, mapped_start = map * start;
  return run(mapped, test::toCloud(mapped_points), threads, &mapped_view, &mapped_start,
             determinant > 0.0 ? SpiralSense::CounterClockwise : SpiralSense::Clockwise);
}

} // namespace

int
judgeInvariance(const Job& job, const Options& options)
{
  Table table(job.name + ": the same path moved, mirrored, scaled, shuffled, and for any number of threads");
  const std::vector<Eigen::Vector3d> points = sampled(job, options.seed).points;
  const Eigen::Vector3d view(0.0, 0.0, 1e4), start = job.surface->outlines().front().front();
  const Run first = run(job, test::toCloud(points), options.threads, &view, &start);
  table.holds("a path is made", first.status.ok(), first.status.message());
  const Path& expected = first.path;
  table.note("points", static_cast<double>(expected.size()), "");

  for (const int threads : {1, 2, 3}) {
    const Run again = run(job, test::toCloud(points), threads, &view, &start);
    table.holds(std::to_string(threads) + " threads: same bytes", sameBytes(first.path, again.path));
  }

  std::vector<Eigen::Vector3d> mixed;
  for (const std::size_t i : test::shuffled(points.size(), options.seed + 5))
    mixed.push_back(points[i]);
  const Eigen::Affine3d as_it_is = Eigen::Affine3d::Identity();
  comparePaths("shuffled", expected, run(job, test::toCloud(mixed), options.threads, &view, &start), as_it_is, table);

  const Eigen::Affine3d moved(test::randomMotion(options.seed + 9, 200.0));
  const Eigen::Affine3d mirrored = moved * Eigen::Scaling(-1.0, 1.0, 1.0);
  const Eigen::Affine3d reduced = as_it_is * Eigen::Scaling(1.0 / 1024), enlarged = moved * Eigen::Scaling(40.0);
  for (const auto& [what, map] : {std::pair{"moved", moved}, {"mirrored", mirrored}, {"a 1024th", reduced}, {"forty times", enlarged}})
    comparePaths(what, expected, runMapped(job, points, map, view, start, options.threads), map.inverse(), table);
  return table.broken();
}

} // namespace pcl_spiral::acceptance
