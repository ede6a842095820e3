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
             const Eigen::Isometry3d& back, Table& table)
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
  Table table(job.name + ": the same path moved, shuffled, and for any number of threads");
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
  const Run other_order = run(job, test::toCloud(mixed), options.threads, &view, &start);
  comparePaths("shuffled", expected, other_order, Eigen::Isometry3d::Identity(), table);

  const Eigen::Isometry3d motion = test::randomMotion(options.seed + 9, 200.0);
  std::vector<Eigen::Vector3d> moved;
  for (const Eigen::Vector3d& p : points)
    moved.push_back(motion * p);
  const Eigen::Vector3d moved_view = motion * view, moved_start = motion * start;
  const Run other_place = run(job, test::toCloud(moved), options.threads, &moved_view, &moved_start);
  comparePaths("moved", expected, other_place, motion.inverse(), table);
  return table.broken();
}

} // namespace pcl_spiral::acceptance
