// SPDX-License-Identifier: BSD-3-Clause
// A step whose side was not scanned parts the surface; a steep surface, a scanned side and the floor of a pocket do not.
#include "support/joining_triangles.h"
#include "support/sampling.h"
#include "support/surfaces.h"

#include <pcl_spiral/graph/impl/surface_graph.h>
#include <pcl_spiral/surface/scanned_surface.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace unseen_steps_test {

namespace {

using namespace pcl_spiral;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double rim = 20.0, radius = 60.0, table = 32.0; // mm

enum class Rows { Jittered, Random, Lines };

/** A dome whose rim is \p high above the table that it lies on; sides are not seen. */
struct Scene {
  std::vector<Vector3d> points;
  std::vector<std::uint8_t> on_dome;

  Scene(double high, double spacing, Rows rows, std::uint64_t seed)
  {
    test::Random random(seed);
    const int half = static_cast<int>(table / spacing);
    for (int i = -half; i <= half; ++i)
      for (int k = -half; k <= half; ++k) {
        const double jitter = rows == Rows::Jittered ? 0.3 : 0.05;
        Vector2d p = spacing * Vector2d(i + random.uniform(-jitter, jitter), k + random.uniform(-jitter, jitter));
        if (rows == Rows::Random)
          p = table * Vector2d(random.uniform(-1, 1), random.uniform(-1, 1));
        if (rows == Rows::Lines)
          p.y() = (k + 0.5 * random.uniform()) * spacing;
        add(p, high, 0.01 * random.normal());
      }
  }

  void add(const Vector2d& p, double high, double noise)
  {
    const double rise = std::sqrt(std::max(0.0, radius * radius - p.squaredNorm())) - std::sqrt(radius * radius - rim * rim);
    on_dome.push_back(p.norm() <= rim);
    points.emplace_back(p.x(), p.y(), (on_dome.back() ? high + rise : 0.0) + noise);
  }
};

SurfaceGraph
graphOf(const std::vector<Vector3d>& points, const Eigen::Isometry3d& motion = Eigen::Isometry3d::Identity())
{
  std::vector<Eigen::Vector3f> moved;
  for (const Vector3d& p : points)
    moved.push_back((motion * p).cast<float>());
  SurfaceGraph graph;
  const Status status = graph.build(moved, SurfaceGraphOptions());
  EXPECT_TRUE(status.ok()) << status.message();
  return graph;
}

double
areaOf(const SurfaceGraph& graph)
{
  const Triangulation& mesh = graph.triangulation();
  double area = 0.0;
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
    const auto& [a, b, c] = mesh.triangle(t);
    area += 0.5 * (graph.position(b) - graph.position(a)).cross(graph.position(c) - graph.position(a)).norm();
  }
  return area;
}

/** Parts of at least a hundredth of the triangles. */
std::size_t
largeParts(const SurfaceGraph& graph)
{
  std::vector<std::size_t> sizes;
  graph.triangulation().parts(sizes);
  return static_cast<std::size_t>(
      std::count_if(sizes.begin(), sizes.end(), [&](std::size_t size) { return 100 * size > graph.triangulation().triangleCount(); }));
}

TEST(UnseenSteps, APartOnATableIsApartFromIt)
{
  constexpr double pi = 3.14159265358979;
  const double cap = 2.0 * pi * radius * (radius - std::sqrt(radius * radius - rim * rim));
  const double whole = 4.0 * table * table - pi * rim * rim + cap;
  std::uint64_t seed = 0;
  for (const Rows rows : {Rows::Jittered, Rows::Random, Rows::Lines})
    for (const double spacing : {0.6, 1.0})
      for (const double spacings : {2.7, 3.0, 4.0, 5.0, 6.5, 8.0, 10.0}) {
        SCOPED_TRACE(std::to_string(static_cast<int>(rows)) + ", spacing " + std::to_string(spacing) + ", high " +
                     std::to_string(spacings));
        const Scene scene(spacings * spacing, spacing, rows, ++seed);
        const SurfaceGraph graph = graphOf(scene.points, test::randomMotion(seed, 100.0));
        EXPECT_EQ(largeParts(graph), 2U);
        EXPECT_LT(test::joiningTriangles(graph, scene.on_dome), 5U) << "of a rim of " << 2.0 * pi * rim / spacing << " points";
        EXPECT_NEAR(areaOf(graph), whole, 2.5 * spacing * 2.0 * pi * rim) << "only triangles at the rim are gone";
      }
}

TEST(UnseenSteps, AWallAcrossWithWavesAndCornersParts)
{
  for (const bool corners : {false, true})
    for (const double high : corners ? std::vector<double>{3.0, 4.0} : std::vector<double>{2.2, 3.0, 4.0})
      for (const std::uint64_t seed : {1, 2, 3}) {
        SCOPED_TRACE(std::to_string(corners) + ", " + std::to_string(high) + " mm, seed " + std::to_string(seed));
        test::Random random(seed);
        std::vector<Vector3d> points;
        std::vector<std::uint8_t> on_top;
        for (int i = -30; i <= 30; ++i)
          for (int k = -30; k <= 30; ++k) {
            const Vector2d p = 0.8 * Vector2d(i + random.uniform(-0.45, 0.45), k + random.uniform(-0.45, 0.45));
            const double wall = corners ? 2.0 * std::abs(std::remainder(p.y(), 8.0)) - 4.0 : 3.0 * std::sin(p.y() / 4.0);
            on_top.push_back(p.x() < wall);
            points.emplace_back(p.x(), p.y(), on_top.back() ? high : 0.0);
          }
        const SurfaceGraph graph = graphOf(points, test::randomMotion(seed, 100.0));
        EXPECT_EQ(largeParts(graph), 2U);
        EXPECT_LE(test::joiningTriangles(graph, on_top), corners ? 10U : 0U) << "of a wall of " << (corners ? 134 : 75) << " points";
      }
}

TEST(UnseenSteps, AFewFalsePointsOnTheSideJoinNothing)
{
  Scene scene(6.0, 0.8, Rows::Jittered, 5);
  test::Random random(6);
  for (int i = 0; i < 6; ++i) { // half on the edge, half below it: mixed pixels
    const double angle = random.uniform(0.0, 6.28);
    scene.points.emplace_back(rim * std::cos(angle), rim * std::sin(angle), random.uniform(2.0, 4.0));
    scene.on_dome.push_back(1);
  }
  EXPECT_EQ(largeParts(graphOf(scene.points)), 2U);
}

TEST(UnseenSteps, AScannedSideJoinsPartAndTable)
{
  Scene scene(5.0, 0.8, Rows::Jittered, 7);
  for (double z = 0.5; z < 4.8; z += 0.7)
    for (double angle = 0.0; angle < 6.28; angle += 0.7 / rim)
      scene.points.emplace_back(rim * std::cos(angle), rim * std::sin(angle), z);
  EXPECT_EQ(largeParts(graphOf(scene.points)), 1U);
}

TEST(UnseenSteps, ASteepSurfaceStaysWhole)
{
  test::Ground form;
  form.amplitude = 20.0;
  form.length_x = form.length_y = 8.0; // up to 68 degrees
  const auto steep = test::ground(form, test::Region({test::rectangle(60.0, 50.0)}));
  for (const double spacing : {0.4, 0.8}) {
    const auto sampled = test::sampleUniform(*steep, static_cast<std::size_t>(steep->area() / (spacing * spacing)), 11);
    EXPECT_EQ(largeParts(graphOf(sampled.points)), 1U) << spacing;
  }
}

TEST(UnseenSteps, ASmallThingAboveIsApartAndASmallFloorBelowIsNot)
{
  for (const double high : {2.4, -2.4}) {
    test::Random random(13);
    std::vector<Vector3d> points;
    for (int i = -60; i <= 60; ++i)
      for (int k = -60; k <= 60; ++k) {
        const Vector2d p = 0.8 * Vector2d(i + random.uniform(-0.3, 0.3), k + random.uniform(-0.3, 0.3));
        points.emplace_back(p.x(), p.y(), p.norm() < 4.0 ? high : 0.0); // 0.8 % of the points
      }
    std::vector<std::size_t> sizes;
    graphOf(points).triangulation().parts(sizes);
    EXPECT_EQ(sizes.size(), high > 0.0 ? 2U : 1U) << high;
  }
}

/** A plate on a gentle dome, its sides not seen: it is named with its points, height and extent. */
TEST(UnseenSteps, APlateOnAPartIsACluster)
{
  constexpr double spacing = 0.8, sphere = 120.0;
  for (const double high : {2.4, 4.0, 7.0})
    for (const double half : {3.0, 4.5}) {
      SCOPED_TRACE(std::to_string(high) + " mm high, " + std::to_string(2.0 * half) + " mm wide");
      test::Random random(17);
      std::vector<Vector3d> points;
      int on_plate = 0;
      for (int i = -40; i <= 40; ++i)
        for (int k = -40; k <= 40; ++k) {
          const Vector2d p = spacing * Vector2d(i + random.uniform(-0.3, 0.3), k + random.uniform(-0.3, 0.3));
          const bool on = (p - Vector2d(5.0, 0.0)).cwiseAbs().maxCoeff() < half;
          const double dome = std::sqrt(sphere * sphere - p.squaredNorm()) - sphere;
          on_plate += on;
          points.emplace_back(p.x(), p.y(), (on ? high : dome) + 0.01 * random.normal());
        }
      ScannedSurface<pcl::PointXYZ> scanned;
      scanned.setInputCloud(test::toCloud(points));
      scanned.setStrict(false);
      scanned.setQuiet(true);
      Surface::ConstPtr surface;
      scanned.compute(surface);
      ASSERT_TRUE(surface) << scanned.getStatus().message();
      ASSERT_EQ(surface->clusters().size(), 1U);
      const StandingCluster& cluster = surface->clusters()[0];
      EXPECT_NEAR(static_cast<double>(cluster.indices.size()), on_plate, 0.1 * on_plate);
      EXPECT_NEAR(cluster.height, high + 0.2, 0.3) << "over the dome";
      EXPECT_LT((cluster.place.head<2>() - Vector2d(5.0, 0.0)).norm(), spacing);
      EXPECT_TRUE(cluster.hides_surface);
    }
}

} // namespace

} // namespace unseen_steps_test
