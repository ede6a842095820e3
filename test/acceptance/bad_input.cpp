// SPDX-License-Identifier: BSD-3-Clause
#include "cases.h"
#include "table.h"

#include "support/checked_path.h"
#include "support/move_tree.h"

#include <cmath>
#include <functional>
#include <limits>

namespace pcl_spiral::acceptance {

namespace {

using Points = std::vector<Eigen::Vector3d>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Points
line()
{
  Points points;
  for (int i = 0; i < 1000; ++i)
    points.emplace_back(0.1 * i, 0.2 * i, 0.05 * i);
  return points;
}

Points
closedSphere(std::uint64_t seed)
{
  test::Random random(seed);
  Points points;
  for (int i = 0; i < 20000; ++i)
    points.push_back(50.0 * Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized());
  return points;
}

Points
twoSheets(std::uint64_t seed)
{
  Points points = test::sampleUniform(*test::flat(test::Region({test::rectangle(80, 60)})), 8000, seed).points;
  for (std::size_t i = 0; i < 8000; ++i)
    points.push_back(points[i] + Eigen::Vector3d(0.0, 0.0, 8.0));
  return points;
}

/** The run must fail, report the reason, and leave no path. */
void
refused(const std::string& what, const Job& job, const Points& points, const Options& options, Table& table)
{
  const Run result = run(job, test::toCloud(points), options.threads);
  const bool held = !result.status.ok() && result.path.empty() && result.status.message().size() > 30;
  table.holds(what, held, result.status.message());
}

/** Non-finite points and duplicates are removed and counted, and change nothing else. */
void
dirty(const Job& job, const Options& options, Table& table)
{
  const Points clean = sampled(job, options.seed).points;
  Points points;
  for (std::size_t i = 0; i < clean.size(); ++i) {
    points.push_back(clean[i]);
    if (i % 100 == 7)
      points.emplace_back(i % 200 == 7 ? nan : 1.0, 2.0, std::numeric_limits<double>::infinity());
    if (i % 50 == 3)
      points.push_back(clean[i]);
  }
  const Run expected = run(job, test::toCloud(clean), options.threads);
  const Run result = run(job, test::toCloud(points), options.threads);
  table.holds("with NaN and duplicates: a path is made", expected.status.ok() && result.status.ok(), result.status.message());
  table.atMost("  non-finite points miscounted", std::abs(static_cast<double>(result.report.nonfinite_points) - 300.0), 0.0, "");
  table.atMost("  duplicates miscounted", std::abs(static_cast<double>(result.report.duplicate_points) - 600.0), 0.0, "");
  if (expected.path.empty() || result.path.empty())
    return;
  const test::MoveTree tree(test::fromToolpath(expected.path).contacts);
  double off = 0.0;
  for (const Eigen::Vector3d& p : test::fromToolpath(result.path).contacts)
    off = std::max(off, tree.nearest(p).first);
  table.atMost("  off the path of the clean cloud", off, 1e-3);
}

} // namespace

int
judgeBadInput(const Options& options)
{
  Table table("bad_input: refused with a reason, no path left");
  const Job good = job("saddle");
  const Points points = test::sampleUniform(*good.surface, 5000, options.seed).points;
  refused("no point", good, {}, options, table);
  refused("one point", good, {{1.0, 2.0, 3.0}}, options, table);
  refused("two points", good, {{1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}}, options, table);
  refused("one place 500 times", good, Points(500, {1.0, 2.0, 3.0}), options, table);
  refused("all NaN", good, Points(500, {nan, nan, nan}), options, table);
  refused("a line", good, line(), options, table);
  refused("a closed sphere", good, closedSphere(options.seed), options, table);
  refused("two parallel sheets", good, twoSheets(options.seed), options, table);
  const auto with = [&](const std::string& what, const std::function<void(Job&)>& change) {
    Job changed = good;
    change(changed);
    refused(what, changed, points, options, table);
  };
  with("tool radius 0", [](Job& j) { j.tool_radius = 0.0; });
  with("tool radius -5", [](Job& j) { j.tool_radius = -5.0; });
  with("tool radius NaN", [](Job& j) { j.tool_radius = nan; });
  with("scallop 0", [](Job& j) { j.scallop_height = 0.0; });
  with("scallop as large as the tool", [](Job& j) { j.scallop_height = j.tool_radius; });
  with("scallop NaN", [](Job& j) { j.scallop_height = nan; });
  with("chord error 0", [](Job& j) { j.chord_error = 0.0; });
  with("chord error -0.01", [](Job& j) { j.chord_error = -0.01; });
  Generator without;
  without.setToolRadius(5.0);
  without.setScallopHeight(0.02);
  Path path;
  path.resize(3);
  without.compute(path);
  table.holds("no cloud set", !without.getStatus().ok() && path.empty(), without.getStatus().message());
  dirty(good, options, table);
  return table.broken();
}

} // namespace pcl_spiral::acceptance
