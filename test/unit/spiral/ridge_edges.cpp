// SPDX-License-Identifier: BSD-3-Clause
// Edges along ridges, on a plane triangle, where the distance from the sides and its three ridges, which meet in one point, are known.
#include "spiral/field/ridge_edges.h"
#include "spiral/outlines/handle_loop.h"

#include "support/sampling.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace ridge_edges_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

const std::array<Eigen::Vector3d, 3> corners{Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(20, 0, 0), Eigen::Vector3d(6, 15, 0)};

/** Distances from the three sides, mm, ascending. */
std::array<double, 3>
fromSides(const Eigen::Vector3d& p)
{
  std::array<double, 3> distances{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3d side = (corners[(i + 1) % 3] - corners[i]).normalized();
    distances[i] = side.cross(p - corners[i]).norm();
  }
  std::sort(distances.begin(), distances.end());
  return distances;
}

/** A mesh of the triangle with \p parts of each side; the nodes inside are moved by up to \p uneven of a part. Step-overs are 1 mm. */
StepOverMesh
triangleMesh(std::uint32_t parts, double uneven, std::uint64_t seed)
{
  StepOverMesh mesh;
  Random random(seed);
  std::vector<Triangulation::Triangle> triangles;
  const auto at = [](std::uint32_t i, std::uint32_t j) { return i * (i + 1) / 2 + j; };
  StepOverMetric metric = stepOverMetric(Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitX(), 0.0, 0.0, 1.0, 0.1);
  metric = metric.times(1.0 / metric.squaredLength(Eigen::Vector3d::UnitX()));
  const double part = 15.0 / parts;
  for (std::uint32_t i = 0; i <= parts; ++i)
    for (std::uint32_t j = 0; j <= i; ++j) {
      Eigen::Vector3d p = corners[0] + (corners[1] - corners[0]) * (static_cast<double>(i - j) / parts) +
                          (corners[2] - corners[0]) * (static_cast<double>(j) / parts);
      if (j > 0 && j < i && i < parts)
        p += uneven * part * Eigen::Vector3d(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), 0.0);
      mesh.positions.push_back(p);
      mesh.normals.emplace_back(0.0f, 0.0f, 1.0f);
      mesh.metric.push_back(metric);
      if (i > 0 && j > 0)
        triangles.push_back({at(i - 1, j - 1), at(i, j - 1), at(i, j)});
      if (i > 0 && j > 0 && j < i)
        triangles.push_back({at(i - 1, j - 1), at(i, j), at(i - 1, j)});
    }
  mesh.triangles = Triangulation(mesh.size(), std::move(triangles));
  for (const std::vector<std::uint32_t>& loop : mesh.triangles.boundaryLoops()) {
    mesh.rims.emplace_back();
    for (const std::uint32_t h : loop)
      mesh.rims.back().push_back(mesh.triangles.origin(h));
  }
  return mesh;
}

double
areaOf(const StepOverMesh& mesh, double& least)
{
  double sum = 0.0;
  least = 1e30;
  for (std::size_t t = 0; t < mesh.triangles.triangleCount(); ++t) {
    const auto& c = mesh.triangles.triangle(t);
    const double area = 0.5 * (mesh.positions[c[1]] - mesh.positions[c[0]]).cross(mesh.positions[c[2]] - mesh.positions[c[0]]).z();
    sum += area;
    least = std::min(least, area);
  }
  return sum;
}

bool
hasEdge(const Triangulation& triangles, std::uint32_t from, std::uint32_t to)
{
  for (std::size_t o = triangles.outgoingBegin(from); o < triangles.outgoingBegin(from + 1); ++o)
    if (triangles.target(triangles.outgoing(o)) == to)
      return true;
  return false;
}

} // namespace

class RidgeEdges : public ::testing::TestWithParam<std::pair<std::uint32_t, double>> {};

TEST_P(RidgeEdges, LieOnTheRidgesAndLeaveTheMeshWhole)
{
  const auto [parts, uneven] = GetParam();
  std::size_t crossings = 0, beside = 0, off = 0; // nodes on edges, those not on a ridge, and those of another height
  std::array<std::size_t, 4> patterns{};          // triangles by the number of their sides that a ridge crosses
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(std::to_string(seed));
    StepOverMesh mesh = triangleMesh(parts, uneven, seed);
    const std::size_t before = mesh.size();
    MarchedDistances marched;
    ASSERT_TRUE(marchOn(mesh, marched));
    double worst = 0.0;
    for (std::size_t v = 0; v < before; ++v)
      worst = std::max(worst, std::abs(marched.distance[v] - fromSides(mesh.positions[v])[0]));
    const std::vector<double> distance = marched.distance;
    const Triangulation old = mesh.triangles;
    std::vector<std::uint8_t> may_cross(before, 1);
    mesh = withRidgeEdges(std::move(mesh), marched, may_cross);

    double least = 0.0;
    EXPECT_NEAR(areaOf(mesh, least), 150.0, 1e-9);
    EXPECT_GT(least, 0.0);
    EXPECT_EQ(missingEuler(mesh.positions, mesh.triangles), 0u);
    EXPECT_EQ(mesh.triangles.boundaryLoops().size(), 1u);
    EXPECT_TRUE(std::equal(distance.begin(), distance.end(), marched.distance.begin()));
    ASSERT_GT(mesh.size(), before);
    std::size_t edges_cut = 0;
    for (std::uint32_t t = 0; t < old.triangleCount(); ++t) {
      std::size_t crossed = 0;
      for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h)
        crossed += old.opposite(h) != Triangulation::none && !hasEdge(mesh.triangles, old.origin(h), old.target(h));
      ++patterns[crossed];
      edges_cut += crossed;
    }
    const std::size_t on_edges = before + edges_cut / 2; // these come first, then those halfway
    const double edge = 20.0 * (1.0 + 2.0 * uneven) / parts;
    for (std::size_t v = before; v < mesh.size(); ++v) {
      const std::array<double, 3> sides = fromSides(mesh.positions[v]);
      if (v < on_edges) {
        ++crossings;
        beside += sides[1] - sides[0] > 4.0 * worst + 1e-9;
        off += std::abs(marched.distance[v] - sides[0]) > 2.0 * worst + 1e-9;
      }
      EXPECT_LT(sides[1] - sides[0], 4.0 * worst + edge) << v; // a node halfway to a corner may lie so far from the ridge
      EXPECT_NEAR(marched.distance[v], sides[0], 2.0 * worst + 0.5 * edge) << v;
      EXPECT_TRUE(may_cross[v]);
    }
  }
  std::printf(
      "  %zu triangles with one side crossed, %zu with two, %zu with three; of %zu crossings %zu beside the ridge, %zu off its height\n",
      patterns[1], patterns[2], patterns[3], crossings, beside, off);
  EXPECT_LT(beside, crossings / 20); // a front that came along an edge has another direction than the edge
  EXPECT_LT(off, crossings / 50);
  EXPECT_GT(patterns[1], 0u);
  EXPECT_GT(patterns[2], 0u);
  EXPECT_GT(patterns[3], 0u);
}

INSTANTIATE_TEST_SUITE_P(Meshes, RidgeEdges,
                         ::testing::Values(std::make_pair(10u, 0.2), std::make_pair(21u, 0.3), std::make_pair(40u, 0.1)));

TEST(RidgeEdgesOfNone, LeaveTheMeshAsItIs)
{
  StepOverMesh mesh = triangleMesh(12, 0.2, 1);
  MarchedDistances marched;
  ASSERT_TRUE(marchOn(mesh, marched));
  std::vector<std::uint8_t> nowhere(mesh.size(), 0);
  const std::size_t nodes = mesh.size(), triangles = mesh.triangles.triangleCount();
  mesh = withRidgeEdges(std::move(mesh), marched, nowhere);
  EXPECT_EQ(mesh.size(), nodes);
  EXPECT_EQ(mesh.triangles.triangleCount(), triangles);
}

} // namespace ridge_edges_test
