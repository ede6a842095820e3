// SPDX-License-Identifier: BSD-3-Clause
// Given loops: the sense of an outline drawn across the surface, and the area inside a loop.
#include "support/even_cloud.h"
#include "support/surfaces.h"

#include "surface/gap_filling.h"
#include <pcl_spiral/features/impl/boundary_loops_engine.h>
#include <pcl_spiral/spiral/impl/loop_check.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace loop_check_test {

namespace {

using namespace pcl_spiral;
using Eigen::Vector3d;

constexpr double sphere = 150.0;

/** A circle about \p x, \p y on the sphere, counter-clockwise from above. */
BoundaryLoop
circleOnSphere(double radius, double x = 0.0, double y = 0.0)
{
  BoundaryLoop loop;
  for (int i = 0; i < 360; ++i) {
    const double a = 2.0 * M_PI * i / 360.0, u = x + radius * std::cos(a), v = y + radius * std::sin(a);
    loop.curve.emplace_back(u, v, std::sqrt(sphere * sphere - u * u - v * v));
  }
  loop.points = loop.curve;
  loop.length = length(loop.curve, true);
  return loop;
}

BoundaryLoop
reversed(BoundaryLoop loop)
{
  std::reverse(loop.curve.begin(), loop.curve.end());
  std::reverse(loop.points.begin(), loop.points.end());
  return loop;
}

test::SurfacePtr
dome(const std::vector<test::PlaneLoop>& holes = {})
{
  std::vector<test::PlaneLoop> outlines{test::circle({0, 0}, 60.0)};
  outlines.insert(outlines.end(), holes.begin(), holes.end());
  return test::ball(sphere, test::Region(outlines));
}

std::vector<SurfaceGraph>
clouds(const test::AnalyticSurface& surface)
{
  std::vector<SurfaceGraph> graphs;
  graphs.push_back(test::graphOf(test::evenPoints(surface, 2.0, 10.0, 1)));
  for (const std::uint64_t seed : {1, 2, 3})
    graphs.push_back(test::graphOf(test::sampleUniform(surface, 12000, seed).points));
  return graphs;
}

TEST(LoopCheck, AnOutlineAcrossTheSurfaceGoesRoundWhatItBounds)
{
  for (const SurfaceGraph& graph : clouds(*dome()))
    for (double radius = 20.0; radius < 50.0; radius += 1.5) {
      SCOPED_TRACE(radius);
      BoundaryLoop loop = circleOnSphere(radius);
      EXPECT_TRUE(checkLoops(graph, {loop}).ok()) << checkLoops(graph, {loop}).message();
      const Status status = checkLoops(graph, {reversed(loop)});
      EXPECT_EQ(status.code(), StatusCode::InvalidInput);
      EXPECT_NE(status.message().find("on its right"), std::string::npos) << status.message();
      loop.type = LoopType::Inner; // the area outside it is machined
      EXPECT_FALSE(checkLoops(graph, {loop}).ok());
      EXPECT_TRUE(checkLoops(graph, {reversed(loop)}).ok());
    }
}

TEST(LoopCheck, LoopsThatWereFoundHaveTheSurfaceOnTheirLeft)
{
  const auto holed = dome({test::circle({20, 5}, 9.0), test::circle({-25, 5}, 4.0), test::rectangle(30, 4, {0, -30})});
  for (const auto& surface : {holed, test::kidneyPatch(), test::ellPatch(), test::offCentreAnnulus(), test::spheroidCap(80, 45)})
    for (const SurfaceGraph& graph : clouds(*surface)) {
      std::vector<BoundaryLoop> loops;
      ASSERT_TRUE(findBoundaryLoops(graph, {}, loops).ok());
      EXPECT_TRUE(checkLoops(graph, loops).ok()) << checkLoops(graph, loops).message();
      for (const BoundaryLoop& loop : loops)
        EXPECT_FALSE(checkLoops(graph, {reversed(loop)}).ok());
    }
}

TEST(LoopCheck, AFoundEdgeOverTheSurfaceIsNoFaultOfAProgrammer)
{
  const auto holed = dome({test::circle({20, 5}, 9.0)});
  for (const SurfaceGraph& graph : clouds(*holed)) {
    std::vector<BoundaryLoop> loops;
    ASSERT_TRUE(findBoundaryLoops(graph, {}, loops).ok());
    EXPECT_TRUE(checkFoundLoops(graph, loops).ok());
    loops.back() = reversed(loops.back()); // as the edge of something above the surface runs
    const Status status = checkFoundLoops(graph, loops);
    EXPECT_EQ(status.code(), StatusCode::Failed);
    EXPECT_NE(status.message().find("no single sheet"), std::string::npos) << status.message();
    EXPECT_NE(status.message().find("setCrop"), std::string::npos) << status.message();
    EXPECT_EQ(status.message().find("reverse"), std::string::npos) << status.message();
  }
}

TEST(LoopCheck, PointsInsideALoop)
{
  for (const SurfaceGraph& graph : clouds(*dome({test::circle({20, 5}, 12.0)}))) {
    std::vector<BoundaryLoop> loops;
    ASSERT_TRUE(findBoundaryLoops(graph, {}, loops).ok());
    ASSERT_EQ(loops.size(), 2u);
    EXPECT_EQ(pointsInside(graph, loops[1].points), 0u);
    EXPECT_EQ(pointsInside(graph, circleOnSphere(12.0, 20.0, 5.0).points), 0u) << "drawn by hand";
    const double depth = 1.5 * graph.spacing();
    std::size_t inside = 0;
    for (std::size_t i = 0; i < graph.size(); ++i)
      inside += (graph.position(i).head<2>() - Eigen::Vector2d(-30, 0)).norm() < 12.0 - depth;
    const auto counted = static_cast<double>(pointsInside(graph, circleOnSphere(12.0, -30.0, 0.0).points));
    EXPECT_GT(inside, 10u);
    EXPECT_NEAR(counted, static_cast<double>(inside), 0.15 * static_cast<double>(inside)) << "seen along the normal, not from above";
  }
}

} // namespace

} // namespace loop_check_test
