// SPDX-License-Identifier: BSD-3-Clause
// What the coverage of a linked path finds and what it leaves, against the distance of every tested node from every move of the path.
#include "spiral/linking/path_cover.h"

#include "support/outlines.h"
#include "support/sampling.h"

#include <pcl_spiral/core/impl/pass_ranges.h>
#include <pcl_spiral/core/step_over.h>
#include <pcl_spiral/spiral/loop_linking.h>
#include <pcl_spiral/spiral/scallop_loops.h>
#include <pcl_spiral/spiral/step_over_field.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace path_cover_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

namespace {

constexpr double radius = 5.0, scallop = 0.1;

/** The field of an outlined part, and a path over its loops that was not moved. */
struct Linked {
  StepOverDistance field;
  LinkedPath path;
  double held = 0.0; ///< step-overs of the pass along the rim
};

Linked
linked(const std::string& outline, bool one_way, std::size_t left_out = 0)
{
  Linked made;
  StepOverField<pcl::PointXYZ> field;
  field.setInputCloud(toCloud(sampleUniform(*outlinedPart(outline, 0, 0.5), 3000, 7).points));
  field.setToolRadius(radius);
  field.setScallopHeight(scallop);
  field.compute(made.field);
  EXPECT_TRUE(field.getStatus().ok()) << field.getStatus().message();
  ScallopLoopSet set;
  EXPECT_TRUE(makeScallopLoops(made.field, {}, set));
  made.held = 0.97 * set.loops.front().length();
  set.loops.resize(set.loops.size() - left_out);
  const Status status = linkLoops(set.loops, made.path, std::nullopt, one_way);
  EXPECT_TRUE(status.ok()) << status.message();
  return made;
}

/** Distance of \p p from the straight move between \p a and \p b in the metric of p, at a hundred places and by the parabola through the
 *  best three of them. */
double
distanceByPlaces(const Vector3d& p, const StepOverMetric& metric, const Vector3d& a, const Vector3d& b)
{
  constexpr int places = 100;
  const auto at = [&](int k) { return metric.squaredLength(p - a - (b - a) * k / places); };
  int best = 0;
  for (int k = 1; k <= places; ++k)
    best = at(k) < at(best) ? k : best;
  if (best == 0 || best == places)
    return std::sqrt(at(best));
  const double low = at(best - 1), middle = at(best), high = at(best + 1), bend = low - 2.0 * middle + high;
  return std::sqrt(std::max(0.0, bend > 0.0 ? middle - (low - high) * (low - high) / (8.0 * bend) : middle));
}

/** The largest distance of a node about a ridge from the moves of a path, lifts left out, and how many are farther than \p than. */
struct Farthest {
  double distance = 0.0;
  std::size_t places = 0;
};

Farthest
farthest(const Linked& made, double than)
{
  const Polyline& points = made.path.points;
  Farthest found;
  for (std::size_t v = 0; v < made.field.mesh.size(); ++v) {
    if (!made.field.is_fine[v])
      continue;
    const Vector3d& p = made.field.mesh.positions[v];
    const double reach = 2.0 * longestStepOver(made.field.mesh.metric[v]);
    double least = 1e30;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      if (!beginsPass(made.path.passes, i + 1) && std::min((points[i] - p).norm(), (points[i + 1] - p).norm()) < reach)
        least = std::min(least, distanceByPlaces(p, made.field.mesh.metric[v], points[i], points[i + 1]));
    found.distance = std::max(found.distance, least);
    found.places += least > than;
  }
  return found;
}

class PathCover : public testing::TestWithParam<std::pair<const char*, bool>> {};

} // namespace

TEST_P(PathCover, LeavesNoNodeFartherThanItSays)
{
  constexpr double covered = 0.503, rounding = 1e-6;
  const auto [outline, one_way] = GetParam();
  Linked made = linked(outline, one_way);
  const Farthest before = farthest(made, covered + rounding);
  CoverReport figures;
  ASSERT_TRUE(coverPath(made.field, made.held, {}, made.path, figures));
  EXPECT_GT(before.places, 0U) << "the part has nothing to move the path for";
  EXPECT_GE(figures.places, before.places) << "places between nodes count too";
  EXPECT_GE(figures.farthest_before, before.distance - rounding);
  const Farthest after = farthest(made, figures.farthest + rounding);
  EXPECT_EQ(after.places, 0U) << after.distance << " step-overs from the path, and the largest distance told is " << figures.farthest;
  EXPECT_LT(figures.farthest, figures.farthest_before);
  EXPECT_LT(figures.left, figures.places / 2);
}

/** Loops of the user's own may leave places farther than a step-over from all turns: the path goes there, too. */
TEST_P(PathCover, GoesToPlacesThatALoopLeftOutUncovers)
{
  constexpr double most = 0.51; // the goal is 0.503; moved turns rub on each other
  const auto [outline, one_way] = GetParam();
  Linked made = linked(outline, one_way, 1);
  const Farthest before = farthest(made, most);
  CoverReport figures;
  ASSERT_TRUE(coverPath(made.field, made.held, {}, made.path, figures));
  const Farthest after = farthest(made, most);
  EXPECT_GT(before.distance, 1.0);
  EXPECT_EQ(after.places, 0U) << after.distance;
  EXPECT_LT(figures.farthest, before.distance) << "the farthest that is named";
}

TEST_P(PathCover, DoesNotMoveTheHeldPass)
{
  const auto [outline, one_way] = GetParam();
  Linked made = linked(outline, one_way);
  const LinkedPath before = made.path;
  CoverReport figures;
  ASSERT_TRUE(coverPath(made.field, made.held, {}, made.path, figures));
  double way = 0.0;
  for (std::size_t i = 1; i < made.path.points.size() && way < made.held - 0.1; ++i) {
    way += made.path.metric[i].length(made.path.points[i] - made.path.points[i - 1]);
    double off = 1e30;
    for (std::size_t k = 0; k + 1 < before.points.size() && off > 1e-9; ++k)
      off = std::min(off, distanceByPlaces(made.path.points[i], made.path.metric[i], before.points[k], before.points[k + 1]));
    ASSERT_LT(off, 1e-6) << "point " << i << " of the pass along the rim moved";
  }
}

INSTANTIATE_TEST_SUITE_P(Outlines, PathCover,
                         testing::Values(std::make_pair("L", false), std::make_pair("dumbbell", false), std::make_pair("dumbbell", true)),
                         [](const auto& info) { return std::string(info.param.first) + (info.param.second ? "OneWay" : ""); });

} // namespace path_cover_test
