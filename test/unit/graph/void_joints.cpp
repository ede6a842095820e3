// SPDX-License-Identifier: BSD-3-Clause
// What stands beside a part, more than six spacings away and of the same height, is no part of it: neither from its corners nor from those
// of the part. Narrower voids, changes of density and lines far apart part nothing.
#include "support/joining_triangles.h"
#include "support/sampling.h"

#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/graph/impl/surface_graph.h>

#include <gtest/gtest.h>

#include <vector>

namespace void_joints_test {

namespace {

using namespace pcl_spiral;
using Eigen::Vector2d;

/** Flat points, and which of two things they are of. */
struct Scene {
  std::vector<Eigen::Vector3f> points;
  std::vector<std::uint8_t> of_second;

  /** A square, a point every \p spacing mm, jittered by that share of it. */
  void addSquare(const Vector2d& centre, double half, double turn, double spacing, double jitter, std::uint8_t second, test::Random& random)
  {
    const int count = static_cast<int>(half / spacing);
    for (int i = -count; i <= count; ++i)
      for (int k = -count; k <= count; ++k) {
        const Vector2d at = spacing * Vector2d(i + jitter * random.uniform(-1, 1), k + jitter * random.uniform(-1, 1));
        const Vector2d p = centre + Eigen::Rotation2Dd(turn) * at;
        points.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(0.01 * random.normal()));
        of_second.push_back(second);
      }
  }

  SurfaceGraph graph() const
  {
    SurfaceGraph made;
    EXPECT_TRUE(made.build(points, SurfaceGraphOptions()).ok());
    return made;
  }
  std::size_t joining() const { return test::joiningTriangles(graph(), of_second); }
};

constexpr double part_spacing = 0.7, clamp_spacing = 0.95, part_half = 21.0, clamp_half = 7.6; // mm

/** A part and a clamp of which a corner, or a side, is \p gap away from a corner, or a side, of the part. */
Scene
partAndClamp(double gap, bool part_corner, bool clamp_corner, double jitter, std::uint64_t seed)
{
  test::Random random(seed);
  const double eighth = full_turn / 8.0, part_reach = part_half * (part_corner ? std::sqrt(2.0) : 1.0),
               clamp_reach = clamp_half * (clamp_corner ? std::sqrt(2.0) : 1.0);
  Scene scene;
  scene.addSquare(Vector2d::Zero(), part_half, part_corner ? eighth : 0.0, part_spacing, jitter, 0, random);
  scene.addSquare(Vector2d(part_reach + gap + clamp_reach, 0.0), clamp_half, clamp_corner ? eighth : 0.0, clamp_spacing, 0.0, 1, random);
  return scene;
}

} // namespace

TEST(VoidJoints, WhatStandsBesideThePartIsApart)
{
  for (const double gap : {6.4, 7.0, 8.5, 10.0}) // 6.7 to 10.5 spacings of the clamp, which are the wider ones
    for (int corners = 0; corners < 4; ++corners)
      for (const double jitter : {0.1, 0.4})
        for (std::uint64_t seed = 1; seed <= 3; ++seed)
          EXPECT_EQ(partAndClamp(gap, (corners & 1) != 0, (corners & 2) != 0, jitter, seed).joining(), 0u)
              << "gap " << gap << " corners " << corners << " jitter " << jitter << " seed " << seed;
}

TEST(VoidJoints, ANarrowerVoidIsSurface)
{
  for (int corners = 0; corners < 4; ++corners)
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
      EXPECT_GT(partAndClamp(3.0, (corners & 1) != 0, (corners & 2) != 0, 0.1, seed).joining(), 0u) << corners << ' ' << seed;
}

TEST(VoidJoints, APartThatIsApartReachesNowhereOver)
{
  for (const double gap : {5.5, 5.8, 6.1}) // about the limit: one or two parts, but no triangles of one part over the void
    for (int corners = 0; corners < 4; ++corners)
      for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const Scene scene = partAndClamp(gap, (corners & 1) != 0, (corners & 2) != 0, 0.3, seed);
        const SurfaceGraph graph = scene.graph();
        std::vector<std::size_t> sizes;
        graph.triangulation().parts(sizes);
        if (sizes.size() > 1)
          EXPECT_EQ(test::joiningTriangles(graph, scene.of_second), 0u) << gap << ' ' << corners << ' ' << seed;
      }
}

TEST(VoidJoints, AChangeOfDensityPartsNothing)
{
  for (const double coarse : {1.2, 2.4, 3.6}) { // beside points every 0.3 mm
    test::Random random(7);
    Scene scene;
    scene.addSquare(Vector2d::Zero(), 9.0, 0.0, 0.3, 0.3, 0, random);
    scene.addSquare(Vector2d(9.0 + coarse + 36.0, 0.0), 36.0, 0.0, coarse, 0.1, 1, random);
    EXPECT_GT(scene.joining(), 4u) << coarse;
  }
}

TEST(VoidJoints, ScanLinesFarApartAreOneSurface)
{
  for (const double apart : {5.0, 10.0, 20.0, 30.0, 32.0}) { // times the distance along a line
    test::Random random(9);
    std::vector<Eigen::Vector3f> points;
    for (int line = 0; line < 30; ++line)
      for (int i = 0; i < 30 * static_cast<int>(apart); ++i)
        points.emplace_back(static_cast<float>(i + random.uniform(-0.2, 0.2)), static_cast<float>(apart * line),
                            static_cast<float>(0.01 * random.normal()));
    SurfaceGraph graph;
    ASSERT_TRUE(graph.build(points, SurfaceGraphOptions()).ok());
    std::vector<std::size_t> sizes;
    graph.triangulation().parts(sizes);
    EXPECT_EQ(sizes.size(), 1u) << apart;
    EXPECT_EQ(graph.triangulation().boundaryLoops().size(), 1u) << apart;
  }
}

} // namespace void_joints_test
