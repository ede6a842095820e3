// SPDX-License-Identifier: BSD-3-Clause
// The bound of the depth that a cutter cuts between two free places, against dense samples in the swept cutter.
#include <pcl_spiral/core/impl/swept_error.h>

#include "support/cutters.h"
#include "support/sampling.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace swept_error_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

namespace {

constexpr double degree = 3.14159265358979323846 / 180.0;

Vector3d
unitVector(Random& random)
{
  return Vector3d(random.normal(), random.normal(), random.normal()).normalized();
}

/** Deepest of many points of the swept cutter that the cutter at the ends does not cover. */
double
deepestByForce(Random& random, const CutterProfile& c, const CutterPlace& a, const CutterPlace& b, int samples)
{
  constexpr int steps = 16;
  double deepest = 0.0;
  for (int i = 0; i < samples; ++i) {
    const CutterPlace at = onTheWay(a, b, random.uniform(0.05, 0.95));
    const Vector3d e1 = at.axis.unitOrthogonal(), e2 = at.axis.cross(e1);
    const double angle = random.uniform(0.0, 2.0 * M_PI), height = c.topHeight() * std::pow(random.uniform(0.0, 1.0), 2);
    const double l = c.radiusAt(height) * (i % 4 == 0 ? std::sqrt(random.uniform(0.0, 1.0)) : 1.0);
    const double inwards = 0.3 * c.radius() * std::pow(random.uniform(0.0, 1.0), 4);
    const Vector3d side = std::cos(angle) * e1 + std::sin(angle) * e2;
    const Vector3d p = at.tip + height * at.axis + l * side + inwards * (at.axis - side).normalized();
    if (depthOf(p, c, a) > 0.0 || depthOf(p, c, b) > 0.0)
      continue;
    for (int k = 1; k < steps; ++k)
      deepest = std::max(deepest, depthOf(p, c, onTheWay(a, b, static_cast<double>(k) / steps)));
  }
  return deepest;
}

} // namespace

TEST(SweptError, IsExactForABall)
{
  Random random(1);
  const double R = 5.0;
  const CutterProfile ball(CutterShape::ball(R));
  for (int i = 0; i < 200; ++i) {
    const Vector3d way = random.uniform(0.05, 3.0) * unitVector(random);
    const double cusp = R - std::sqrt(R * R - 0.25 * way.squaredNorm());
    const double found = sweptError(ball, way.z(), way.head<2>().norm());
    ASSERT_LE(found, cusp * (1 + 1e-12));
    if (std::abs(way.z()) < 0.6 * way.norm()) {
      ASSERT_NEAR(found, cusp, 1e-12);
    }
    // A ball turned about its centre does not move.
    const CutterPlace a{Vector3d::Zero(), unitVector(random)}, b{R * (a.axis - Vector3d::UnitZ()), Vector3d::UnitZ()};
    ASSERT_LE(sweptError(ball, a, b), R * std::pow(std::acos(a.axis.z()), 2) / 8.0 + 1e-9);
  }
}

TEST(SweptError, OfAFlatEndIsItsStepAndItsWedge)
{
  const CutterProfile flat(CutterShape::flatEnd(6.0, 20.0));
  EXPECT_NEAR(sweptError(flat, 0.0, 2.0), 6.0 - std::sqrt(35.0), 1e-12);
  EXPECT_NEAR(sweptError(flat, 0.3, 0.4), 0.3 * 0.4 / 0.5, 1e-12);
  EXPECT_EQ(sweptError(flat, 5.0, 0.0), 0.0);
  EXPECT_EQ(sweptError(flat, 0.0, 0.0), 0.0);
  EXPECT_TRUE(std::isinf(sweptError(flat, 0.0, 12.1)));
}

TEST(SweptError, BoundsWhatTheSweptCutterCuts)
{
  Random random(2);
  double nearest = 0.0;
  for (int i = 0; i < 1500; ++i) {
    const CutterProfile c(randomCutter(random));
    const double step = c.radius() * std::pow(10.0, random.uniform(-2.0, 0.0));
    CutterPlace a, b;
    b.tip = step * unitVector(random);
    if (i % 3 == 0)
      b.tip.z() *= 0.05;
    const double bound = sweptError(c, b.tip.z(), b.tip.head<2>().norm());
    const double cut = deepestByForce(random, c, a, b, 2000);
    ASSERT_LE(cut, bound + 1e-9) << i << ": step " << b.tip.transpose() << ", R " << c.radius() << ", r " << c.cornerRadius()
                                 << ", flank angle " << c.flankAngle() / degree;
    if (bound > 0.0)
      nearest = std::max(nearest, cut / bound);
  }
  EXPECT_GT(nearest, 0.9); // the sampling would detect a bound that is too low
}

TEST(SweptError, BoundsWhatTheTurningCutterCuts)
{
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const CutterProfile c(randomCutter(random));
    CutterPlace a, b;
    b.tip = c.radius() * std::pow(10.0, random.uniform(-2.0, -0.5)) * unitVector(random);
    b.axis = Eigen::AngleAxisd(degree * std::pow(10.0, random.uniform(-1.0, 1.0)), unitVector(random)) * a.axis;
    const double bound = sweptError(c, a, b);
    ASSERT_LE(deepestByForce(random, c, a, b, 1500), bound + 1e-9)
        << i << ": step " << b.tip.transpose() << ", axis " << b.axis.transpose() << ", R " << c.radius() << ", r " << c.cornerRadius()
        << ", top " << c.topHeight() << ", flank angle " << c.flankAngle() / degree;
  }
}

} // namespace swept_error_test
