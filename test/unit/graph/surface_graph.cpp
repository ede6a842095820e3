// SPDX-License-Identifier: BSD-3-Clause
// The graph of a surface: topology on known surfaces, the empty-circle property, orientation, invariance.
#include <pcl_spiral/graph/impl/surface_graph.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <omp.h>

#include <random>
#include <set>

namespace surface_graph_test {

namespace {

using pcl_spiral::SurfaceGraph;
using Points = std::vector<Eigen::Vector3f>;

Points
randomSquare(std::size_t n, double size, std::uint64_t seed)
{
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> u(0.0, size);
  Points points(n);
  for (auto& p : points) {
    const double x = u(random), y = u(random);
    p = {float(x), float(y), float(0.0005 * x * x - 0.0003 * y * y)};
  }
  return points;
}

Points
randomSphere(std::size_t n, double radius, bool upper_half, std::uint64_t seed)
{
  std::mt19937_64 random(seed);
  std::normal_distribution<double> g;
  Points points(n);
  for (auto& p : points) {
    Eigen::Vector3d d(g(random), g(random), g(random));
    d *= radius / d.norm();
    if (upper_half)
      d.z() = std::abs(d.z());
    p = d.cast<float>();
  }
  return points;
}

Points
lattice(int columns, int rows, double dx, double dy, double jitter, std::uint64_t seed)
{
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> u(-jitter, jitter);
  Points points;
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j)
      points.emplace_back(float(i * dx + u(random)), float(j * dy + u(random)), 0.0f);
  return points;
}

struct Topology {
  long euler = 0;
  std::size_t loops = 0;
  std::size_t parts = 0;
  long pinches = 0; ///< points where a loop touches itself: a thin triangle of the rim is connected only at its ends
};

Topology
topologyOf(const SurfaceGraph& graph)
{
  const auto& mesh = graph.triangulation();
  std::size_t boundary = 0;
  for (std::uint32_t h = 0; h < mesh.halfEdgeCount(); ++h)
    boundary += mesh.opposite(h) == pcl_spiral::Triangulation::none;
  const long edges = (mesh.halfEdgeCount() + boundary) / 2;
  std::vector<std::size_t> sizes;
  mesh.parts(sizes);
  const auto loops = mesh.boundaryLoops();
  long pinches = 0;
  for (const auto& loop : loops) {
    std::set<std::uint32_t> seen;
    for (const std::uint32_t h : loop)
      pinches += !seen.insert(mesh.origin(h)).second;
  }
  return {long(graph.size()) - edges + long(mesh.triangleCount()), loops.size(), sizes.size(), pinches};
}

SurfaceGraph
graphOf(const Points& points, pcl_spiral::SurfaceGraphOptions options = {})
{
  SurfaceGraph graph;
  const auto status = graph.build(points, options);
  EXPECT_TRUE(status.ok()) << status.message();
  return graph;
}

TEST(SurfaceGraph, RandomSquareIsADisc)
{
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Topology t = topologyOf(graphOf(randomSquare(20000, 300.0, seed)));
    EXPECT_EQ(t.euler + t.pinches, 1);
    EXPECT_LE(t.pinches, 2);
    EXPECT_EQ(t.loops, 1u);
    EXPECT_EQ(t.parts, 1u);
  }
}

TEST(SurfaceGraph, LatticesAreDiscs)
{
  for (const double jitter : {0.0, 1e-4, 0.2})
    EXPECT_EQ(topologyOf(graphOf(lattice(80, 60, 1.0, 1.0, jitter, 4))).euler, 1) << jitter;
  const Topology lines = topologyOf(graphOf(lattice(400, 40, 1.0, 10.0, 0.2, 5)));
  EXPECT_EQ(lines.euler, 1);
  EXPECT_EQ(lines.loops, 1u);
}

TEST(SurfaceGraph, SphereIsClosedAndFacesOutward)
{
  const auto graph = graphOf(randomSphere(30000, 100.0, false, 6));
  const Topology t = topologyOf(graph);
  EXPECT_EQ(t.euler, 2);
  EXPECT_EQ(t.loops, 0u);
  EXPECT_LT(graph.meanNormal().norm(), 0.01);
  for (std::size_t i = 0; i < graph.size(); ++i)
    ASSERT_GT(graph.normal(i).dot(graph.position(i)) / 100.0, 0.99);
}

TEST(SurfaceGraph, NormalsFaceZOrTheViewPoint)
{
  const auto points = randomSphere(20000, 100.0, true, 7);
  EXPECT_GT(graphOf(points).meanNormal().z(), 0.3);
  pcl_spiral::SurfaceGraphOptions inside;
  inside.view_point = Eigen::Vector3d(0, 0, 10);
  EXPECT_LT(graphOf(points, inside).meanNormal().z(), -0.3);
  inside.flip_normals = true;
  EXPECT_GT(graphOf(points, inside).meanNormal().z(), 0.3);
}

TEST(SurfaceGraph, TrianglesHaveEmptyCircles)
{
  const auto graph = graphOf(randomSquare(1500, 100.0, 8));
  const auto& mesh = graph.triangulation();
  std::size_t filled = 0;
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
    const auto& c = mesh.triangle(t);
    const Eigen::Vector3d a = graph.position(c[0]), b = graph.position(c[1]), p = graph.position(c[2]);
    const Eigen::Vector3d u = b - a, v = p - a, w = u.cross(v);
    EXPECT_GT(w.dot(graph.normal(c[0])), 0.0);
    const Eigen::Vector3d centre = a + (u.squaredNorm() * v.cross(w) + v.squaredNorm() * w.cross(u)) / (2.0 * w.squaredNorm());
    const double radius = (a - centre).norm();
    for (std::size_t i = 0; i < graph.size(); ++i)
      filled += (graph.position(i) - centre).norm() < 0.99 * radius;
  }
  EXPECT_LE(filled, 3u); // slivers along the rim, on a slightly curved surface
}

TEST(SurfaceGraph, SameForAnyOrderAndThreads)
{
  auto points = randomSquare(5000, 100.0, 9);
  omp_set_num_threads(1);
  const auto first = graphOf(points);
  omp_set_num_threads(2);
  std::shuffle(points.begin(), points.end(), std::mt19937_64(3));
  const auto second = graphOf(points);
  ASSERT_EQ(first.triangulation().triangleCount(), second.triangulation().triangleCount());
  for (std::size_t t = 0; t < first.triangulation().triangleCount(); ++t)
    ASSERT_EQ(first.triangulation().triangle(t), second.triangulation().triangle(t));
  for (std::size_t i = 0; i < first.size(); ++i)
    ASSERT_EQ(first.normals()[i], second.normals()[i]);
}

/** A closed fan round point 0 and one more triangle on a spoke: three triangles meet there. */
TEST(Triangulation, LoopsEndWhereThreeTrianglesShareAnEdge)
{
  const pcl_spiral::Triangulation mesh(5, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 4}});
  std::size_t boundary = 0, in_loops = 0;
  for (std::uint32_t h = 0; h < mesh.halfEdgeCount(); ++h) {
    const std::uint32_t other = mesh.opposite(h);
    boundary += other == pcl_spiral::Triangulation::none;
    if (other != pcl_spiral::Triangulation::none) {
      EXPECT_EQ(mesh.opposite(other), h);
    }
  }
  for (const auto& loop : mesh.boundaryLoops())
    in_loops += loop.size();
  EXPECT_EQ(in_loops, boundary);
}

TEST(SurfaceGraph, RefusesTooFewAndCoincident)
{
  SurfaceGraph graph;
  EXPECT_FALSE(graph.build(randomSquare(49, 10.0, 1), {}).ok());
  EXPECT_FALSE(graph.build(Points(500, Eigen::Vector3f(1, 2, 3)), {}).ok());
}

TEST(SurfaceGraph, FindsIsolatedPointsAndNoOthers)
{
  auto points = randomSphere(20000, 100.0, true, 12);
  EXPECT_TRUE(graphOf(points).isolatedPoints().empty());
  std::vector<std::uint32_t> outliers;
  for (std::uint32_t i = 500; i < points.size(); i += 2500) { // one to four spacings off, on both sides
    points[i] *= 1.0f + (i % 5000 < 2500 ? 0.018f : -0.05f);
    outliers.push_back(i);
  }
  EXPECT_EQ(graphOf(points).isolatedPoints(), outliers);
}

TEST(SurfaceGraph, OnePointFarOffIsFoundAndTurnsNothing)
{
  const Points dome = randomSphere(5000, 40.0, true, 3);
  const std::vector<Eigen::Vector3f> ways{{1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}, {0.3f, 1, -1}, {-1, 1, 0.2f}};
  for (int power = 3; power <= 12; ++power)
    for (const Eigen::Vector3f& way : ways) {
      Points points = dome;
      points.push_back(std::pow(10.0f, static_cast<float>(power)) * way);
      SurfaceGraph graph;
      ASSERT_TRUE(graph.build(points, {}).ok());
      EXPECT_EQ(graph.isolatedPoints(), std::vector<std::uint32_t>{5000}) << "1e" << power << " along " << way.transpose();
      EXPECT_GT(graph.meanNormal().z(), 0.4);
      std::size_t inwards = 0;
      for (std::size_t i = 0; i < graph.size(); ++i)
        inwards += graph.blocks().originalIndex(i) != 5000 && graph.normal(i).dot(graph.position(i)) < 0.0;
      EXPECT_LE(inwards, 40u); // only neighbours that took the far point for a near one
    }
}

TEST(SurfaceGraph, PointsOnACreaseAreNotIsolated)
{
  auto points = randomSquare(20000, 100.0, 13);
  for (auto& p : points)
    p.z() = std::abs(p.x() - 50.0f); // a right angle along the middle
  EXPECT_TRUE(graphOf(points).isolatedPoints().empty());
}

} // namespace

} // namespace surface_graph_test
