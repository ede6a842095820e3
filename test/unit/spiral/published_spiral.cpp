// SPDX-License-Identifier: BSD-3-Clause
// The published method from a cloud to a path: limits of the path, the same bytes for any number of threads,
// failures.
#include "support/even_cloud.h"
#include "support/surfaces.h"

#include "spiral/lines/surface_centre.h"
#include <pcl_spiral/common/impl/thread_limit.h>
#include <pcl_spiral/features/impl/boundary_loops_engine.h>
#include <pcl_spiral/spiral/impl/published_spiral.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace published_spiral_test {

namespace {

using namespace pcl_spiral;
using Eigen::Vector3d;

SpiralSettings
cutter(double radius = 10.0, double scallop = 0.05)
{
  SpiralSettings settings;
  settings.tool_radius = radius;
  settings.scallop_height = scallop;
  return settings;
}

double
degreesBetween(const Vector3d& a, const Vector3d& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180.0 / M_PI;
}

/** Checks the limits of every published path; \return the largest distance of its contacts from the exact surface. */
double
expectSoundPath(const test::AnalyticSurface& exact, const SurfaceGraph& graph, const SpiralSettings& settings,
                const PublishedResult& result)
{
  const PublishedReport& figures = result.figures;
  const std::size_t n = result.contacts.size();
  EXPECT_EQ(result.normals.size(), n);
  EXPECT_EQ(result.axes.size(), n);
  EXPECT_EQ(result.arc_lengths.size(), n);
  EXPECT_EQ(result.turns.size(), n);
  EXPECT_DOUBLE_EQ(figures.step_over,
                   2.0 * std::sqrt(2.0 * settings.scallop_height * settings.tool_radius)); // (16)
  double longest = 0.0;
  for (const RadialLine& line : result.lines.lines)
    longest = std::max(longest, line.length());
  EXPECT_EQ(figures.turns, static_cast<std::size_t>(std::ceil(longest / figures.step_over)));
  EXPECT_TRUE(std::is_sorted(result.turns.begin(), result.turns.end()));
  EXPECT_EQ(result.turns.front(), 0.0f);
  EXPECT_EQ(result.turns.back(),
            static_cast<float>(figures.turns + (result.lines.inner.empty() ? 1 : 2))); // with the loops
  EXPECT_LE(figures.longest_move, 1.1 * figures.step);
  double largest = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const double off = std::abs(exact.signedDistance(result.contacts[i]));
    largest = std::max(largest, off);
    squares += off * off;
    EXPECT_NEAR(degreesBetween(result.axes[i].cast<double>(), result.normals[i]), settings.tilt_angle, 1e-3);
    if (i > 0)
      EXPECT_NEAR(result.arc_lengths[i] - result.arc_lengths[i - 1], (result.contacts[i] - result.contacts[i - 1]).norm(), 1e-9);
  }
  std::printf("  %zu lines (%zu unsettled), step %.3f mm, %zu turns, %zu points, %.0f mm; off the surface by "
              "%.4f mm at most, "
              "%.4f rms (spacing %.2f)\n",
              figures.lines, figures.unsettled_lines, figures.step, figures.turns, n, result.arc_lengths.back(), largest,
              std::sqrt(squares / static_cast<double>(n)), graph.spacing());
  return largest;
}

class OnEvenDome : public ::testing::Test {
protected:
  static void SetUpTestSuite()
  {
    graph_ = new SurfaceGraph(test::graphOf(test::evenPoints(*test::spheroidCap(200.0, 100.0), 2.0, 10.0, 1)));
  }
  static void TearDownTestSuite() { delete graph_; }
  const test::SurfacePtr exact_ = test::spheroidCap(200.0, 100.0);
  static const SurfaceGraph* graph_;
};
const SurfaceGraph* OnEvenDome::graph_ = nullptr;

TEST_F(OnEvenDome, PathFromThePoleToTheRim)
{
  PublishedResult result;
  double last_share = 0.0;
  const auto progress = [&](double share, const std::string&) {
    EXPECT_GE(share, last_share);
    last_share = share;
    return true;
  };
  const Status status = planPublished(*graph_, cutter(), progress, result);
  ASSERT_TRUE(status.ok()) << status.message();
  EXPECT_EQ(last_share, 1.0);
  EXPECT_EQ(result.loops.size(), 1u);
  // Order zero moves the path in by (k1 + k2) h^2 / 4; at the rim there are neighbours only on one side.
  EXPECT_LT(expectSoundPath(*exact_, *graph_, cutter(), result), 0.25);
  EXPECT_LT((result.contacts.front() - Vector3d(0, 0, 100)).norm(), graph_->spacing());
  EXPECT_LT(exact_->rimDistance(result.contacts.back()), graph_->spacing());
}

TEST_F(OnEvenDome, NormalsAreThoseOfTheNearestPoints)
{
  PublishedResult result;
  ASSERT_TRUE(planPublished(*graph_, cutter(), {}, result).ok());
  for (std::size_t i = 0; i < result.contacts.size(); i += 997) {
    const Vector3d& p = result.contacts[i];
    std::size_t nearest = 0;
    for (std::size_t j = 1; j < graph_->size(); ++j)
      if ((graph_->position(j) - p).squaredNorm() < (graph_->position(nearest) - p).squaredNorm())
        nearest = j;
    EXPECT_LT(degreesBetween(result.normals[i], graph_->normal(nearest)),
              0.5); // another point may be as near
  }
}

TEST_F(OnEvenDome, SameBytesForAnyThreads)
{
  PublishedResult results[2];
  for (const int threads : {1, 2}) {
    const ThreadLimit limit(threads);
    ASSERT_TRUE(planPublished(*graph_, cutter(), {}, results[threads - 1]).ok());
  }
  EXPECT_EQ(results[0].contacts, results[1].contacts);
  EXPECT_EQ(results[0].normals, results[1].normals);
  EXPECT_EQ(results[0].axes, results[1].axes);
  EXPECT_EQ(results[0].arc_lengths, results[1].arc_lengths);
  EXPECT_EQ(results[0].turns, results[1].turns);
}

TEST_F(OnEvenDome, CanBeCancelledInEveryStage)
{
  for (const char* stage : {"boundaries", "radial lines", "spiral", "projection", "crossings"}) {
    PublishedResult result;
    const auto progress = [&](double, const std::string& now) { return now != stage; };
    EXPECT_EQ(planPublished(*graph_, cutter(), progress, result).code(), StatusCode::Cancelled) << stage;
  }
}

TEST_F(OnEvenDome, RefusesWhatHasNoStep)
{
  std::vector<BoundaryLoop> loops;
  ASSERT_TRUE(findBoundaryLoops(*graph_, {}, loops).ok());
  PublishedResult result;
  const Status tall = planPublishedWithin(*graph_, loops, cutter(10.0, 10.0), {}, result);
  EXPECT_EQ(tall.code(), StatusCode::InvalidArgument);
  EXPECT_NE(tall.message().find("scallop height of 10 mm"), std::string::npos) << tall.message();
  SpiralSettings off = cutter();
  off.centre = Vector3d(0, 0, 500);
  const Status away = planPublishedWithin(*graph_, loops, off, {}, result);
  EXPECT_EQ(away.code(), StatusCode::InvalidArgument);
  EXPECT_NE(away.message().find("(0, 0, 500) does not lie on the surface"), std::string::npos) << away.message();
}

TEST(PublishedSpiral, BetweenTwoBoundariesInwardClockwise)
{
  const auto exact = test::offCentreAnnulus();
  const SurfaceGraph graph = test::graphOf(test::evenPoints(*exact, 1.5, 20.0, 2));
  SpiralSettings settings = cutter();
  settings.direction = SpiralDirection::Inward;
  settings.sense = SpiralSense::Clockwise;
  PublishedResult result;
  const Status status = planPublished(graph, settings, {}, result);
  ASSERT_TRUE(status.ok()) << status.message();
  EXPECT_LT(expectSoundPath(*exact, graph, settings, result), 0.03);
  const Eigen::Vector2d first = result.contacts.front().head<2>(), last = result.contacts.back().head<2>();
  EXPECT_NEAR(first.norm(), 150.0, graph.spacing());
  EXPECT_NEAR((last - Eigen::Vector2d(40, 25)).norm(), 45.0, graph.spacing());
  double round = 0.0;
  for (std::size_t i = 1; i < result.contacts.size(); ++i) {
    const Eigen::Vector2d a = result.contacts[i - 1].head<2>() - Eigen::Vector2d(40, 25),
                          b = result.contacts[i].head<2>() - Eigen::Vector2d(40, 25);
    round += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)) / (2.0 * M_PI);
  }
  EXPECT_NEAR(round, -static_cast<double>(result.turns.back()),
              0.01); // line 0 does not run along a radius of the hole
  settings.centre = Vector3d(0, 0, 0);
  EXPECT_EQ(planPublished(graph, settings, {}, result).code(), StatusCode::InvalidArgument);
}

TEST(PublishedSpiral, ARandomCloudNeedsLoopsFromElsewhere)
{
  const auto exact = test::spheroidCap(200.0, 100.0);
  const SurfaceGraph graph = test::graphOf(test::sampleUniform(*exact, 20000, 3).points);
  PublishedResult result;
  const Status walked = planPublished(graph, cutter(), {}, result);
  EXPECT_EQ(walked.code(), StatusCode::Failed);
  EXPECT_NE(walked.message().find("the walk along the boundary ends at ("), std::string::npos) << walked.message();
  EXPECT_TRUE(result.contacts.empty());
  std::vector<BoundaryLoop> loops;
  ASSERT_TRUE(findBoundaryLoops(graph, {}, loops).ok());
  const Status given = planPublishedWithin(graph, loops, cutter(), {}, result);
  ASSERT_TRUE(given.ok()) << given.message();
  EXPECT_LT(expectSoundPath(*exact, graph, cutter(), result), 1.0);
}

TEST(PublishedSpiral, FailsWhereTheOutlineIsReentrant)
{
  const SurfaceGraph graph = test::graphOf(test::evenPoints(*test::boomerangPatch(), 2.0, 10.0, 6));
  std::vector<BoundaryLoop> loops;
  ASSERT_TRUE(findBoundaryLoops(graph, {}, loops).ok());
  PublishedResult result;
  const Status status = planPublishedWithin(graph, loops, cutter(), {}, result);
  EXPECT_EQ(status.code(), StatusCode::Failed);
  EXPECT_NE(status.message().find("leaves the surface at ("), std::string::npos) << status.message();
}

TEST(PublishedSpiral, WarnsWhereTheCutterGouges)
{
  const SurfaceGraph graph = test::graphOf(test::evenPoints(*test::bowl(130.0, 100.0), 2.0, 10.0, 7));
  std::vector<BoundaryLoop> loops;
  ASSERT_TRUE(findBoundaryLoops(graph, {}, loops).ok());
  for (const double radius : {20.0, 150.0}) {
    PublishedResult result;
    const Status status = planPublishedWithin(graph, loops, cutter(radius, 0.5), {}, result);
    ASSERT_TRUE(status.ok()) << status.message();
    const bool warned = std::any_of(result.warnings.begin(), result.warnings.end(), [](const pcl_spiral::Diagnostic& warning) {
      return warning.text().find("the cutter gouges there") != std::string::npos;
    });
    EXPECT_EQ(warned, radius > 130.0);
  }
}

TEST(PublishedSpiral, SaysThatTheCentreDidNotSettle)
{
  test::Random random(1);
  std::vector<Vector3d> points;
  for (const double height : {20.0, 40.0, 80.0}) // of the bump; the last is too steep for its points
    for (points.clear(); points.size() < 3000;) {
      const double x = random.uniform(-60, 60), y = random.uniform(-60, 60);
      if (std::hypot(x, y) < 60.0)
        points.emplace_back(x, y, height * std::exp(-(x * x + y * y) / 300.0));
    }
  const SurfaceGraph graph = test::graphOf(points);
  std::vector<BoundaryLoop> loops;
  ASSERT_TRUE(findBoundaryLoops(graph, {}, loops).ok());
  const MlsSurface surface(graph);
  const auto found = balancedCentre(surface, loops[0].curve);
  ASSERT_TRUE(found);
  ASSERT_FALSE(found->settled);
  SpiralSettings settings = cutter();
  settings.chord_error = 0.5; // few lines
  PublishedResult result;
  planPublishedWithin(graph, loops, settings, {}, result);
  EXPECT_FALSE(result.lines.centre_settled);
  settings.centre = found->position;
  planPublishedWithin(graph, loops, settings, {}, result);
  EXPECT_TRUE(result.lines.centre_settled);
}

} // namespace

} // namespace published_spiral_test
