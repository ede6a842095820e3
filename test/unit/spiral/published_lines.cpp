// SPDX-License-Identifier: BSD-3-Clause
// Published radial lines, and the step of (13)-(15): against meridians, exact surfaces, sagittas; failures of
// lines.
#include "spiral/published/published_lines.h"
#include "spiral/published/published_step.h"
#include "support/even_cloud.h"
#include "support/plane_lines.h"
#include "support/surfaces.h"

#include <pcl_spiral/features/impl/boundary_loops_engine.h>

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace published_lines_test {

namespace {

using namespace pcl_spiral;
using Eigen::Vector3d;

constexpr double chord_error = 0.005;

/** A cloud, its surface by the published method, its loops. */
struct Scan {
  explicit Scan(const std::vector<Vector3d>& points)
  : graph(test::graphOf(points)), surface(graph, 0, ProjectionMethod::DirectionalCentroid)
  {
    EXPECT_TRUE(findBoundaryLoops(graph, {}, loops).ok());
  }
  const SurfaceGraph graph;
  const MlsSurface surface;
  std::vector<BoundaryLoop> loops;
};

/** Largest distance of the inner stations of the lines from the exact surface. */
double
largestDeviation(const test::AnalyticSurface& exact, const std::vector<RadialLine>& lines)
{
  double largest = 0.0;
  for (const RadialLine& line : lines)
    for (std::size_t k = 1; k + 1 < line.feet.size(); ++k)
      largest = std::max(largest, std::abs(exact.signedDistance(line.feet[k].position)));
  return largest;
}

class OnDome : public ::testing::Test {
protected:
  static void SetUpTestSuite() { scan_ = new Scan(test::evenPoints(*test::spheroidCap(200.0, 100.0), 1.5, 10.0, 4)); }
  static void TearDownTestSuite() { delete scan_; }
  const test::SurfacePtr exact_ = test::spheroidCap(200.0, 100.0);
  static const Scan* scan_;
};
const Scan* OnDome::scan_ = nullptr;

TEST_F(OnDome, LinesAreMeridiansInOrder)
{
  RadialLineSet set;
  PublishedLineReport figures;
  const Vector3d pole(0, 0, 100);
  const PublishedLineRequest request{scan_->surface, scan_->loops[0], nullptr, pole, Vector3d(200, 0, 0), chord_error, {}};
  const Status status = publishedLines(request, set, figures);
  ASSERT_TRUE(status.ok()) << status.message();
  const auto n = static_cast<double>(set.lines.size());
  EXPECT_EQ(set.lines.size(), publishedLineCount(scan_->loops[0].length, chord_error, scan_->graph.spacing()));
  double sideways = 0.0, curvature = 0.0;
  std::size_t stations = 0;
  for (std::size_t i = 0; i < set.lines.size(); ++i) {
    const RadialLine& line = set.lines[i];
    EXPECT_EQ(line.feet.front().position, pole);
    EXPECT_EQ(line.curve.position(line.curve.lastParameter()), line.feet.back().position);
    EXPECT_NEAR(line.rim_share, static_cast<double>(i) / n, 1e-12);
    const Vector3d end = line.feet.back().position, across = Vector3d(-end.y(), end.x(), 0).normalized();
    EXPECT_NEAR(std::remainder(std::atan2(end.y(), end.x()) / (2.0 * M_PI) - line.rim_share, 1.0), 0.0, 2e-3);
    for (std::size_t k = 1; k + 1 < line.feet.size(); ++k) {
      const SurfaceFoot& foot = line.feet[k];
      sideways = std::max(sideways, std::abs(foot.position.dot(across)));
      const auto [least, most] = exact_->principalCurvatures(foot.position);
      curvature += std::abs(0.5 * (foot.curvature1 + foot.curvature2 - least - most)) / most;
      ++stations;
    }
  }
  const double off = largestDeviation(*exact_, set.lines);
  std::printf("  %.0f lines, %zu unsettled by %.4f mm at most; %.4f mm off the meridians, %.4f mm off the "
              "surface; mean "
              "curvature wrong by %.1f %%\n",
              n, figures.unsettled, figures.largest_move, sideways, off, 100.0 * curvature / stations);
  EXPECT_LT(sideways, 0.2 * scan_->graph.spacing());
  EXPECT_LT(off, 0.1);
  EXPECT_LT(curvature / static_cast<double>(stations), 0.15);
}

TEST_F(OnDome, SameBytesForAnyThreads)
{
  const PublishedLineRequest request{scan_->surface, scan_->loops[0], nullptr, Vector3d(0, 0, 100), {}, chord_error, {}};
  RadialLineSet sets[2];
  const int before = omp_get_max_threads();
  for (const int threads : {1, 2}) {
    omp_set_num_threads(threads);
    PublishedLineReport figures;
    ASSERT_TRUE(publishedLines(request, sets[threads - 1], figures).ok());
  }
  omp_set_num_threads(before);
  ASSERT_EQ(sets[0].lines.size(), sets[1].lines.size());
  for (std::size_t i = 0; i < sets[0].lines.size(); ++i) {
    EXPECT_EQ(sets[0].lines[i].curve.controlPoints(), sets[1].lines[i].curve.controlPoints());
    for (std::size_t k = 0; k < sets[0].lines[i].feet.size(); ++k)
      EXPECT_EQ(sets[0].lines[i].feet[k].curvature1, sets[1].lines[i].feet[k].curvature1);
  }
}

TEST_F(OnDome, CanBeCancelled)
{
  PublishedLineRequest request{scan_->surface, scan_->loops[0], nullptr, Vector3d(0, 0, 100), {}, chord_error, {}};
  request.progress = [](double) { return false; };
  RadialLineSet set;
  PublishedLineReport figures;
  EXPECT_EQ(publishedLines(request, set, figures).code(), StatusCode::Cancelled);
}

TEST(PublishedLines, BetweenTwoBoundaries)
{
  const auto exact = test::offCentreAnnulus();
  const Scan scan(test::evenPoints(*exact, 1.5, 10.0, 5));
  ASSERT_EQ(scan.loops.size(), 2u);
  RadialLineSet set;
  PublishedLineReport figures;
  const Status status = publishedLines({scan.surface, scan.loops[0], &scan.loops[1], {}, {}, chord_error, {}}, set, figures);
  ASSERT_TRUE(status.ok()) << status.message();
  const Eigen::Vector2d hole(40, 25);
  double round = 0.0, before = 0.0;
  for (std::size_t i = 0; i <= set.lines.size(); ++i) {
    const RadialLine& line = set.lines[i % set.lines.size()];
    const Vector3d start = line.feet.front().position, end = line.feet.back().position;
    EXPECT_NEAR((start.head<2>() - hole).norm(), 45.0, 1.5);
    EXPECT_NEAR(end.head<2>().norm(), 150.0, 1.5);
    const double angle = std::atan2(start.y() - hole.y(), start.x() - hole.x());
    if (i > 0) {
      const double step = std::remainder(angle - before, 2.0 * M_PI);
      EXPECT_GT(step, -1e-3); // partners never go back
      round += step;
    }
    before = angle;
  }
  EXPECT_NEAR(round, 2.0 * M_PI, 1e-6);
  EXPECT_EQ(set.inner.front(), set.lines[0].feet.front().position);
  EXPECT_LT(largestDeviation(*exact, set.lines), 0.02);
}

TEST(PublishedLines, SayWhereALineLeavesTheSurface)
{
  const Scan scan(test::evenPoints(*test::ellPatch(), 2.0, 10.0, 6));
  Vector3d low = Vector3d::Constant(1e9);
  for (const Vector3d& p : scan.loops[0].curve)
    low = low.cwiseMin(p);
  const Vector3d centre = scan.surface.project(Vector3d(low.x() + 150.0, low.y() + 45.0, scan.graph.position(0).z())).position;
  RadialLineSet set;
  PublishedLineReport figures;
  const Status status = publishedLines({scan.surface, scan.loops[0], nullptr, centre, {}, chord_error, {}}, set, figures);
  EXPECT_EQ(status.code(), StatusCode::Failed);
  for (const char* word : {"leaves the surface at (", "outline is re-entrant"})
    EXPECT_NE(status.message().find(word), std::string::npos) << status.message();
}

TEST(PublishedLines, SayWhereTheGraphFallsApart)
{
  std::vector<Vector3d> points = test::evenPoints(*test::flat(test::Region({test::circle({0, 0}, 40.0)})), 1.5, 10.0, 7);
  const Scan one(points);
  const std::size_t half = points.size();
  for (std::size_t i = 0; i < half; ++i)
    points.push_back(points[i] + Vector3d(200, 0, 0));
  const SurfaceGraph both = test::graphOf(points);
  const MlsSurface surface(both, 0, ProjectionMethod::DirectionalCentroid);
  RadialLineSet set;
  PublishedLineReport figures;
  const Status status = publishedLines({surface, one.loops[0], nullptr, Vector3d(200, 0, 0), {}, chord_error, {}}, set, figures);
  EXPECT_EQ(status.code(), StatusCode::Failed);
  EXPECT_NE(status.message().find("no way over the edges of the elliptic Gabriel graph leads from (200, 0, 0)"), std::string::npos)
      << status.message();
}

/** Largest distance of an arc from its chord, by points of the arc. */
double
sagitta(double radius, double chord)
{
  const double half = std::asin(0.5 * chord / radius);
  double largest = 0.0;
  for (int k = -1000; k <= 1000; ++k)
    largest = std::max(largest, radius * (std::cos(half * k / 1000.0) - std::cos(half)));
  return largest;
}

TEST(PublishedLines, CountKeepsTheRimsChordError)
{
  for (const double length : {300.0, 1234.5, 10367.0})
    for (const double e : {0.001, 0.005, 0.05}) {
      const std::size_t count = publishedLineCount(length, e, 1e-3);
      const double radius = length / (2.0 * M_PI);
      const auto chord = [&](std::size_t n) { return 2.0 * radius * std::sin(M_PI / static_cast<double>(n)); };
      EXPECT_LE(sagitta(radius, chord(count)), e * (1.0 + 1e-9));
      EXPECT_GT(sagitta(radius, chord(count - 2)), e);
    }
  EXPECT_EQ(publishedLineCount(1000.0, 1e-9, 10.0), 200u); // no closer than half a spacing
}

TEST(PublishedStep, IsTheChordOfTheSharpestStation)
{
  auto lines = test::straightLines([](std::size_t) { return Vector3d(0, 0, 0); }, test::ring(100.0, 16));
  EXPECT_EQ(publishedStep(lines, chord_error, 10.0), 10.0); // plane: the longest step
  lines[3].feet[40].curvature1 = 1.0 / 80.0;
  lines[9].feet[7].curvature2 = -1.0 / 25.0; // hollow counts as much
  lines[9].feet[8].curvature1 = 1.0 / 26.0;
  for (const double e : {0.001, 0.005, 0.1}) {
    const double step = publishedStep(lines, e, 10.0);
    EXPECT_NEAR(step, 2.0 * std::sqrt(2.0 * 25.0 * e - e * e), 1e-12);
    EXPECT_NEAR(sagitta(25.0, step), e, 1e-9);
  }
  EXPECT_EQ(publishedStep(lines, chord_error, 0.5), 0.5);
}

} // namespace

} // namespace published_lines_test
