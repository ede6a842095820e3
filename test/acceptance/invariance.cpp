#include "cases.h"
#include "table.h"

#include "support/checked_path.h"
#include "support/move_tree.h"

#include <algorithm>
#include <cstring>

namespace pcl_spiral::acceptance {

namespace {

/** The point of \p a farthest from the polyline \p b. */
test::Place
farthest(const test::CheckedPath& a, const test::CheckedPath& b)
{
  const test::MoveTree tree(b.contacts);
  test::Place place;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double d = tree.nearest(a.contacts[i]).first;
    if (d > place.value)
      place = {d, a.contacts[i], 0.0, a.turn(i), i};
  }
  return place;
}

void
comparePaths(const std::string& what, const test::CheckedPath& expected, const Run& other,
             const Eigen::Affine3d& back, Table& table)
{
  table.holds(what + ": a path is made", other.status.ok(), other.status.message());
  if (other.path.empty() || expected.size() == 0)
    return;
  test::CheckedPath path = test::fromToolpath(other.path);
  for (Eigen::Vector3d& p : path.contacts)
    p = back * p;
  table.note(what + ": points", static_cast<double>(path.size()), "");
  table.atMost(what + ": off the first path", farthest(path, expected), 1e-3);
  table.atMost(what + ": first path off it", farthest(expected, path), 1e-3);
  table.atMost(what + ": start", (path.contacts.front() - expected.contacts.front()).norm(), 1e-3);
  table.atMost(what + ": end", (path.contacts.back() - expected.contacts.back()).norm(), 1e-3);
}

/** The job on its points under a similarity: all lengths are scaled with them, and a mirrored part is gone
 * round the other way. */
Run
runMapped(const Job& job, const std::vector<Eigen::Vector3d>& points, const Eigen::Affine3d& map,
          const Eigen::Vector3d& view, const Eigen::Vector3d& start, int threads)
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

/** Every field the same to the bit. */
bool
sameBytes(const Path& a, const Path& b)
{
  const auto same = [](const ToolpathPoint& p, const ToolpathPoint& q) {
    return std::memcmp(p.data, q.data, 3 * sizeof(float)) == 0 &&
           std::memcmp(p.normal, q.normal, 3 * sizeof(float)) == 0 &&
           std::memcmp(p.axis, q.axis, 3 * sizeof(float)) == 0 &&
           std::memcmp(&p.arc_length, &q.arc_length, sizeof(double)) == 0 &&
           std::memcmp(&p.turn, &q.turn, sizeof(float)) == 0;
  };
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), same);
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
  const test::CheckedPath expected = test::fromToolpath(first.path);
  table.note("points", static_cast<double>(expected.size()), "");

  for (const int threads : {1, 2, 3}) {
    const Run again = run(job, test::toCloud(points), threads, &view, &start);
    table.holds(std::to_string(threads) + " threads: same bytes", sameBytes(first.path, again.path));
  }

  std::vector<Eigen::Vector3d> mixed;
  for (const std::size_t i : test::shuffled(points.size(), options.seed + 5))
    mixed.push_back(points[i]);
  const Eigen::Affine3d as_it_is = Eigen::Affine3d::Identity();
  comparePaths("shuffled", expected, run(job, test::toCloud(mixed), options.threads, &view, &start), as_it_is,
               table);

  const Eigen::Affine3d moved(test::randomMotion(options.seed + 9, 200.0));
  const Eigen::Affine3d mirrored = moved * Eigen::Scaling(-1.0, 1.0, 1.0);
  const Eigen::Affine3d reduced = as_it_is * Eigen::Scaling(1.0 / 1024),
                        enlarged = moved * Eigen::Scaling(40.0);
  for (const auto& [what, map] :
       {std::pair{"moved", moved}, {"mirrored", mirrored}, {"a 1024th", reduced}, {"forty times", enlarged}})
    comparePaths(what, expected, runMapped(job, points, map, view, start, options.threads), map.inverse(),
                 table);
  return table.broken();
}

} // namespace pcl_spiral::acceptance
