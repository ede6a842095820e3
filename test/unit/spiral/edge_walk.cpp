// SPDX-License-Identifier: BSD-3-Clause
// Ways along the edges of a mesh, against those that are made shorter edge by edge until none is shorter any more (Bellman, Ford).
#include "spiral/field/edge_walk.h"
#include "spiral/field/ridge_climb.h"

#include "support/sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace edge_walk_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

/** A square lattice of uneven squares, each cut in two, with a metric that changes from side to side. */
StepOverMesh
unevenLattice(std::uint32_t side)
{
  StepOverMesh mesh;
  Random random(7);
  std::vector<Triangulation::Triangle> triangles;
  for (std::uint32_t i = 0; i < side; ++i)
    for (std::uint32_t j = 0; j < side; ++j) {
      mesh.positions.emplace_back(j + 0.3 * random.normal(), i + 0.3 * random.normal(), random.normal());
      mesh.normals.emplace_back(0.0f, 0.0f, 1.0f);
      mesh.metric.push_back(stepOverMetric(Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitX(), 0.0, 0.0, 1.0 + 0.1 * j, 0.1));
      if (i + 1 < side && j + 1 < side) {
        const std::uint32_t v = i * side + j;
        triangles.push_back({v, v + 1, v + side});
        triangles.push_back({v + 1, v + side + 1, v + side});
      }
    }
  mesh.triangles = Triangulation(mesh.size(), std::move(triangles));
  return mesh;
}

std::vector<double>
byRelaxation(const StepOverMesh& mesh, const std::vector<std::uint8_t>& from)
{
  std::vector<double> ways(mesh.size());
  std::transform(from.begin(), from.end(), ways.begin(),
                 [](auto marked) { return marked ? 0.0 : std::numeric_limits<double>::infinity(); });
  for (bool changes = true; changes;) {
    changes = false;
    for (std::size_t t = 0; t < mesh.triangles.triangleCount(); ++t)
      for (const std::uint32_t a : mesh.triangles.triangle(t))
        for (const std::uint32_t b : mesh.triangles.triangle(t))
          if (const double way = ways[a] + (a == b ? 0.0 : edgeLength(mesh, a, b)); way < ways[b] - 1e-12) {
            ways[b] = way;
            changes = true;
          }
  }
  return ways;
}

} // namespace

TEST(EdgeWalk, WaysAreTheShortestUpToTheReach)
{
  const StepOverMesh mesh = unevenLattice(40);
  std::vector<std::uint8_t> from(mesh.size(), 0);
  for (const std::size_t v : {45, 46, 85, 86, 1210})
    from[v] = 1;
  const std::vector<double> ways = byRelaxation(mesh, from);
  const double farthest = *std::max_element(ways.begin(), ways.end());
  for (const double reach : {0.2 * farthest, 0.5 * farthest, 2.0 * farthest}) {
    const std::vector<float> walked = walkedFrom(mesh, from, reach);
    std::size_t within = 0;
    for (std::size_t v = 0; v < mesh.size(); ++v)
      if (ways[v] < reach) {
        ++within;
        EXPECT_NEAR(walked[v], ways[v], 1e-4 * farthest) << v;
      }
      else
        EXPECT_FALSE(walked[v] < ways[v] - 1e-4 * farthest) << v;
    EXPECT_GT(within, from.size() / 50);
  }
}

TEST(EdgeWalk, WithoutMarksNoNodeIsReached)
{
  const StepOverMesh mesh = unevenLattice(5);
  for (const float way : walkedFrom(mesh, std::vector<std::uint8_t>(mesh.size(), 0), 100.0))
    EXPECT_TRUE(std::isinf(way));
}

} // namespace edge_walk_test
