// SPDX-License-Identifier: BSD-3-Clause
// Shank and holder against meshes: a wall without a vertex nearby, and facets flat and curved against dense samples.
#include <pcl_spiral/cutter/cutter_location.h>

#include "cutter/mesh_collision.h"
#include "support/located_on_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace mesh_holder_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

TEST(MeshHolder, AHolderMeetsAWallOfTwoTriangles)
{
  PlainMesh mesh;
  mesh.addQuad({-12, -12, 0}, {12, -12, 0}, {12, 12, 0}, {-12, 12, 0});
  mesh.addQuad({12, -500, -500}, {12, -500, 500}, {12, 500, 500}, {12, 500, -500});
  const auto run = [&](double radius, double clearance) {
    return onMesh(mesh.polygons(), CutterShape::ball(2.0, 10.0), {{{0, 0, 0}, up, up}},
                  [&](Location& l) {
                    l.setHolder({ToolSegment::cylinder(2.0, 20.0, "shank"), ToolSegment{radius - 5.0, radius, 20.0, "chuck"}});
                    l.setHolderClearance(clearance);
                  })
        .locations[0]
        .collision;
  };
  EXPECT_FALSE(run(11.9, 0.0).found());
  const HolderCollision deep = run(15.0, 0.0);
  EXPECT_EQ(deep.segment, 1);
  const double expected = 3.0 / std::hypot(1.0, 0.25);
  EXPECT_LE(deep.depth, expected + 1e-9);
  EXPECT_GE(deep.depth, expected - 1e-3);
  EXPECT_NEAR(deep.place.x(), 12.0, 1e-9);
  EXPECT_TRUE(run(11.9, 0.2).found());
}

TEST(MeshHolder, HoldersAgainstSamplesOfEveryFacet)
{
  Random random(3);
  const HolderProfile holder({ToolSegment::cylinder(3.0, 8.0, "shank"), {6.0, 12.0, 6.0, "nut"}, {12.0, 8.0, 10.0, "chuck"}}, 5.0, 2.0,
                             0.3);
  constexpr double tolerance = 0.01, precision = 1e-3;
  constexpr int n = 300;
  std::size_t found = 0;
  for (int i = 0; i < 300; ++i) {
    PatchCell cell;
    for (int k = 0; k < 3; ++k)
      cell.corners.col(k) = Vector3d(random.uniform(-40, 40), random.uniform(-40, 40), random.uniform(-15, 40));
    for (int k = 0; k < 3; ++k)
      cell.bows.col(k) = i % 2 * Vector3d(random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-4, 4));
    const AxisFrame frame({1.0, -1.0, 0.0}, leaning(up, 40.0, random));
    const double tip = random.uniform(-3.0, 3.0);
    const auto depthAt = [&](const Vector3d& p, int& segment) {
      double depth = 0.0;
      segment = holder.inside(frame.across(p).norm(), frame.along(p) - tip, depth);
      return segment < 0 ? 0.0 : depth;
    };
    const HolderCollision c = findCollision(PatchTree({cell}), holder, frame, tip, tolerance, 1e-4);
    double sampled = 0.0;
    int segment = -1;
    for (int u = 0; u <= n; ++u)
      for (int v = 0; u + v <= n; ++v)
        sampled = std::max(sampled, depthAt(cell.position(Vector3d(n - u - v, u, v) / n), segment));
    found += c.found();
    ASSERT_LE(sampled, (c.found() ? c.depth : tolerance) + precision + 1e-9) << i;
    if (c.found()) {
      ASSERT_NEAR(depthAt(c.place, segment), c.depth, 1e-6) << i;
      EXPECT_EQ(segment, c.segment);
    }
  }
  EXPECT_GT(found, 60u);
}

} // namespace mesh_holder_test
