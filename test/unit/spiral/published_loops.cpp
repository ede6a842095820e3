// SPDX-License-Identifier: BSD-3-Clause
// Published boundaries: flags by equation (1) against a search of all pairs, walks that close and walks
// that end.
#include "spiral/published/published_loops.h"
#include "support/even_cloud.h"
#include "support/sampling.h"
#include "support/surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace published_loops_test {

namespace {

using namespace pcl_spiral;
using Eigen::Vector3d;

/** Flags by the equation itself: the tangential distance of each point from the mean of its nearest others.
 */
std::vector<std::uint8_t>
flagsByAllPairs(const SurfaceGraph& graph, int neighbours, double threshold)
{
  const std::size_t n = graph.size();
  std::vector<std::uint8_t> flags(n);
  std::vector<std::size_t> order(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Vector3d p = graph.position(i);
    const auto distance = [&](std::size_t j) { return (graph.position(j) - p).norm(); };
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
    Vector3d offset = -p;
    for (int k = 1; k <= neighbours; ++k)
      offset += graph.position(order[k]) / neighbours;
    offset -= offset.dot(graph.normal(i)) * graph.normal(i);
    flags[graph.blocks().originalIndex(i)] = offset.norm() / distance(order[neighbours]) > threshold;
  }
  return flags;
}

TEST(PublishedLoops, FlagsFollowEquationOne)
{
  const SurfaceGraph graph = test::graphOf(test::sampleUniform(*test::ellPatch(), 1500, 1).points);
  for (const int neighbours : {12, 32}) {
    const auto flags = centroidFlags(graph, neighbours, 0.31);
    EXPECT_EQ(flags, flagsByAllPairs(graph, neighbours, 0.31));
    EXPECT_GT(std::count(flags.begin(), flags.end(), 1), 100);
  }
}

TEST(PublishedLoops, WalkClosesRoundAnEvenCloud)
{
  const auto surface = test::offCentreAnnulus();
  const SurfaceGraph graph = test::graphOf(test::evenPoints(*surface, 1.5, 20.0, 2));
  std::vector<BoundaryLoop> loops;
  const Status status = publishedLoops(graph, {}, loops);
  ASSERT_TRUE(status.ok()) << status.message();
  ASSERT_EQ(loops.size(), 2u);
  EXPECT_EQ(loops[0].type, LoopType::Outer);
  EXPECT_EQ(loops[1].type, LoopType::Inner);
  for (const BoundaryLoop& loop : loops)
    for (const Vector3d& p : loop.curve)
      EXPECT_LT(surface->rimDistance(p), 1.5 * graph.spacing());
  EXPECT_NEAR(loops[0].length, length(surface->outlines()[0], true), 0.01 * loops[0].length);
}

TEST(PublishedLoops, WalkEndsAtACornerSharperThanItsTurn)
{
  std::vector<Vector3d> grid;
  for (int i = 0; i <= 60; ++i)
    for (int j = 0; j <= 60; ++j)
      grid.emplace_back(i - 30.0, j - 30.0, 0.0);
  const SurfaceGraph graph = test::graphOf(grid);
  PublishedLoopOptions options;
  options.neighbours = 8;
  std::vector<BoundaryLoop> loops;
  EXPECT_TRUE(publishedLoops(graph, options, loops).ok()); // a corner turns by 90 degrees
  EXPECT_EQ(loops.size(), 1u);
  options.max_turn = 60.0;
  const Status status = publishedLoops(graph, options, loops);
  EXPECT_EQ(status.code(), StatusCode::Failed);
  EXPECT_TRUE(loops.empty());
  const std::vector<Eigen::Vector3d> places = status.diagnostic().places();
  ASSERT_EQ(places.size(), 1u) << status.message();
  EXPECT_EQ(std::abs(places[0].x()), 30.0);
  EXPECT_EQ(std::abs(places[0].y()), 30.0);
}

TEST(PublishedLoops, WalkLosesItselfInTheBandOfARandomCloud)
{
  const SurfaceGraph graph = test::graphOf(test::sampleUniform(*test::spheroidCap(200.0, 100.0), 20000, 3).points);
  std::vector<BoundaryLoop> loops;
  const Status status = publishedLoops(graph, {}, loops);
  EXPECT_EQ(status.code(), StatusCode::Failed);
  for (const char* word : {"the walk along the boundary ends at (", "a band of several rows"})
    EXPECT_NE(status.message().find(word), std::string::npos) << status.message();
}

} // namespace

} // namespace published_loops_test
