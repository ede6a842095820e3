// SPDX-License-Identifier: BSD-3-Clause
// Level lines of random functions on random triangulations, against the line in each single triangle.
#include "graph/level_lines.h"

#include "support/sampling.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace level_lines_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

namespace {

SurfaceGraph
graphOf(const AnalyticSurface& surface, std::size_t count, std::uint64_t seed)
{
  std::vector<Eigen::Vector3f> points;
  for (const Vector3d& p : sampleUniform(surface, count, seed).points)
    points.push_back(p.cast<float>());
  SurfaceGraph graph;
  EXPECT_TRUE(graph.build(points, {}).ok());
  return graph;
}

/** Place on the edge a b where a linear function reaches the level. */
Vector3d
placeOn(const SurfaceGraph& graph, const std::vector<double>& values, std::uint32_t a, std::uint32_t b, double level)
{
  const double t = (level - values[a]) / (values[b] - values[a]);
  return graph.position(a) + t * (graph.position(b) - graph.position(a));
}

double
lengthByTriangles(const SurfaceGraph& graph, const std::vector<double>& values, double level)
{
  double sum = 0.0;
  for (std::size_t t = 0; t < graph.triangulation().triangleCount(); ++t) {
    const auto& c = graph.triangulation().triangle(t);
    std::vector<Vector3d> ends;
    for (int i = 0; i < 3; ++i)
      if ((values[c[i]] >= level) != (values[c[(i + 1) % 3]] >= level))
        ends.push_back(placeOn(graph, values, c[i], c[(i + 1) % 3], level));
    if (ends.size() == 2)
      sum += (ends[1] - ends[0]).norm();
  }
  return sum;
}

void
check(const SurfaceGraph& graph, const std::vector<double>& values, const std::vector<double>& levels)
{
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> triangles_at; // of an edge
  for (std::uint32_t h = 0; h < graph.triangulation().halfEdgeCount(); ++h)
    ++triangles_at[std::minmax(graph.triangulation().origin(h), graph.triangulation().target(h))];
  const auto all = levelLines(graph.triangulation(), values, levels);
  ASSERT_EQ(all.size(), levels.size());
  for (std::size_t k = 0; k < levels.size(); ++k) {
    double sum = 0.0;
    std::size_t crossings = 0;
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const LevelLine& line : all[k]) {
      const Polyline points = pointsOf(line, graph.blocks());
      sum += length(points, line.closed);
      for (std::size_t i = 0; i < points.size(); ++i) {
        const LevelCrossing& c = line.crossings[i];
        ASSERT_GE(values[c.above], levels[k]);
        ASSERT_LT(values[c.below], levels[k]);
        ASSERT_LT((points[i] - placeOn(graph, values, c.below, c.above, levels[k])).norm(), 1e-9);
        ASSERT_TRUE(edges.insert(std::minmax(c.below, c.above)).second) << "an edge is crossed twice";
        const bool end = !line.closed && (i == 0 || i + 1 == points.size());
        ASSERT_EQ(triangles_at.at(std::minmax(c.below, c.above)), end ? 1 : 2);
      }
      crossings += points.size();
    }
    std::size_t expected = 0;
    for (const auto& [edge, count] : triangles_at)
      expected += (values[edge.first] >= levels[k]) != (values[edge.second] >= levels[k]);
    ASSERT_EQ(crossings, expected) << k;
    ASSERT_NEAR(sum, lengthByTriangles(graph, values, levels[k]), 1e-9 * (1.0 + sum));
  }
}

} // namespace

TEST(LevelLines, AreThoseOfEachTriangle)
{
  for (const std::uint64_t seed : {1, 2, 3}) {
    const SurfaceGraph graph = graphOf(*quadric(90.0, -60.0, Region({circle({0, 0}, 30.0), circle({5, 0}, 8.0)})), 4000, seed);
    Random random(seed);
    std::vector<double> noise, smooth, steps; // steps: many points exactly on a level, and whole triangles
    for (std::size_t i = 0; i < graph.size(); ++i) {
      noise.push_back(random.uniform());
      smooth.push_back(std::sin(0.2 * graph.position(i).x()) + std::cos(0.3 * graph.position(i).y()));
      steps.push_back(std::floor(0.25 * graph.position(i).x()));
    }
    check(graph, noise, {-1.0, 0.1, 0.5, 0.5, 0.9, 1.0, 2.0});
    check(graph, smooth, {-1.5, -0.5, 0.0, 0.4, 1.2});
    check(graph, steps, {-4.0, -2.0, 0.0, 0.5, 1.0, 4.0});
  }
}

TEST(LevelLines, RunWithTheHigherSideOnTheirLeft)
{
  const SurfaceGraph graph = graphOf(*ball(60.0, Region({circle({0, 0}, 40.0)})), 6000, 4);
  std::vector<double> height;
  for (std::size_t i = 0; i < graph.size(); ++i)
    height.push_back(graph.position(i).z());
  const auto all = levelLines(graph.triangulation(), height, {55.0});
  ASSERT_EQ(all[0].size(), 1u); // round the top, which is on the left: counter-clockwise
  ASSERT_TRUE(all[0][0].closed);
  const Polyline points = pointsOf(all[0][0], graph.blocks());
  double turn = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector3d a = points[i], b = points[(i + 1) % points.size()];
    turn += std::atan2(a.x() * b.y() - a.y() * b.x(), a.x() * b.x() + a.y() * b.y());
  }
  EXPECT_NEAR(turn, 2.0 * M_PI, 1e-9);
}

TEST(LevelLines, EndAtTrianglesWithoutAValue)
{
  const SurfaceGraph graph = graphOf(*flat(Region({rectangle(60.0, 40.0)})), 4000, 5);
  std::vector<double> x;
  for (std::size_t i = 0; i < graph.size(); ++i)
    x.push_back(std::abs(graph.position(i).y()) < 4.0 ? std::numeric_limits<double>::infinity() : graph.position(i).x());
  const auto all = levelLines(graph.triangulation(), x, {3.0});
  std::size_t lines = 0;
  for (const LevelLine& line : all[0]) {
    EXPECT_FALSE(line.closed);
    for (const Vector3d& p : pointsOf(line, graph.blocks())) {
      EXPECT_NEAR(p.x(), 3.0, 1e-9);
      EXPECT_GT(std::abs(p.y()), 4.0 - 1e-6);
    }
    lines += length(pointsOf(line, graph.blocks())) > 10.0;
  }
  EXPECT_EQ(lines, 2u);
}

TEST(LevelLines, AreTheSameForAnyNumberOfThreads)
{
  const SurfaceGraph graph = graphOf(*flat(Region({circle({0, 0}, 30.0)})), 4000, 6);
  std::vector<double> values, levels;
  for (std::size_t i = 0; i < graph.size(); ++i)
    values.push_back(graph.position(i).x() * graph.position(i).y());
  for (int k = -20; k <= 20; ++k)
    levels.push_back(10.0 * k);
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  const auto one = levelLines(graph.triangulation(), values, levels);
  omp_set_num_threads(5);
  const auto five = levelLines(graph.triangulation(), values, levels);
  omp_set_num_threads(before);
  for (std::size_t k = 0; k < levels.size(); ++k) {
    ASSERT_EQ(one[k].size(), five[k].size());
    for (std::size_t l = 0; l < one[k].size(); ++l)
      ASSERT_EQ(pointsOf(one[k][l], graph.blocks()), pointsOf(five[k][l], graph.blocks()));
  }
}

} // namespace level_lines_test
