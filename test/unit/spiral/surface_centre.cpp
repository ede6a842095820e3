// SPDX-License-Identifier: BSD-3-Clause
// The balanced centre against brute force in the plane, and moved together with the part.
#include "support/sampling.h"
#include "support/surfaces.h"

#include "spiral/lines/surface_centre.h"
#include <pcl_spiral/features/impl/boundary_loops_engine.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace surface_centre_test {

namespace {

using namespace pcl_spiral;
using Eigen::Vector2d;
using Eigen::Vector3d;

/** A cloud, its surface and rim. */
struct Part {
  SurfaceGraph graph;
  std::unique_ptr<MlsSurface> surface;
  Polyline rim;

  explicit Part(const std::vector<Vector3d>& points)
  {
    std::vector<Eigen::Vector3f> cloud;
    for (const Vector3d& p : points)
      cloud.push_back(p.cast<float>());
    EXPECT_TRUE(graph.build(cloud, {}).ok());
    std::vector<BoundaryLoop> loops;
    EXPECT_TRUE(findBoundaryLoops(graph, {}, loops).ok());
    surface = std::make_unique<MlsSurface>(graph);
    rim = loops.front().curve;
  }
};

/** max d / sqrt(min d) over the rim, for straight distances, as means of the 16th power. */
double
unevenness(const Polyline& rim, const Vector3d& x)
{
  double far = 0.0, near = 0.0;
  for (const Vector3d& p : rim) {
    const double d = (p - x).norm() / 100.0;
    far += std::pow(d, 16);
    near += std::pow(d, -16);
  }
  return std::pow(far, 1.0 / 16.0) * std::pow(near, 0.5 / 16.0);
}

TEST(BalancedCentre, IsTheBestPlaceOfAFlatPart)
{
  // A right triangle (its Chebyshev centre is the middle of its longest side), and an off-centre quadrilateral.
  const std::vector<test::PlaneLoop> outlines{{{0, 0}, {120, 0}, {0, 90}}, {{0, 0}, {150, 10}, {120, 60}, {10, 80}}};
  for (const test::PlaneLoop& outline : outlines) {
    const auto flat = test::flat(test::Region({outline}));
    const Part part(test::sampleUniform(*flat, 6000, 3).points);
    const auto centre = balancedCentre(*part.surface, part.rim);
    ASSERT_TRUE(centre);
    const Polyline rim = resampled(part.rim, 2000, true);
    Vector3d best = Vector3d::Zero();
    double least = 1e300;
    for (double x = 1.0; x < 150.0; x += 1.0)
      for (double y = 1.0; y < 90.0; y += 1.0)
        if (flat->contains({x, y, 0}) && unevenness(rim, {x, y, 0}) < least) {
          least = unevenness(rim, {x, y, 0});
          best = {x, y, 0};
        }
    EXPECT_LE((centre->position - best).norm(), 1.5) << centre->position.transpose() << " against " << best.transpose();
    EXPECT_LE(unevenness(rim, centre->position), least * 1.001);
    EXPECT_GE(flat->rimDistance(centre->position), 20.0);
  }
}

TEST(BalancedCentre, IsTheMiddleOfWhatIsEvenAllRound)
{
  const auto cap = test::spheroidCap(80, 45);
  const Part part(test::sampleUniform(*cap, 20000, 4).points);
  const auto centre = balancedCentre(*part.surface, part.rim);
  ASSERT_TRUE(centre);
  EXPECT_LE((centre->position - Vector3d(0, 0, 45)).norm(), 0.1);
}

TEST(BalancedCentre, KeepsOffAReentrantRimAndMovesWithThePart)
{
  const auto kidney = test::kidneyPatch();
  const std::vector<Vector3d> points = test::sampleUniform(*kidney, 12000, 5).points;
  const Part part(points);
  const auto centre = balancedCentre(*part.surface, part.rim);
  ASSERT_TRUE(centre);
  EXPECT_GE(kidney->rimDistance(centre->position), 45.0); // of at most 60
  const Eigen::AngleAxisd turn(0.9, Vector3d(0.3, -0.2, 0.8).normalized());
  const Vector3d shift(30, -70, 20);
  std::vector<Vector3d> moved;
  for (const Vector3d& p : points)
    moved.push_back(turn * p + shift);
  const Part other(moved);
  const auto there = balancedCentre(*other.surface, other.rim);
  ASSERT_TRUE(there);
  EXPECT_LE((turn * centre->position + shift - there->position).norm(), 1e-3);
}

} // namespace

} // namespace surface_centre_test
