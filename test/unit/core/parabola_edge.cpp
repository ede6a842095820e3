// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/core/impl/parabola_edge.h>

#include "support/sampling.h"

#include <gtest/gtest.h>

#include <cmath>

namespace parabola_edge_test {

using namespace pcl_spiral;
using Eigen::Vector3d;

namespace {

Vector3d
onEdge(const Vector3d& p0, const Vector3d& d, const Vector3d& bow, double u)
{
  return p0 + d * u - bow * (u * (1.0 - u));
}

} // namespace

TEST(ParabolaEdge, ErrsOnASphereAsItsFormulaSays)
{
  constexpr double rho = 50.0;
  for (const double phi : {0.05, 0.1, 0.2}) {
    const Vector3d n0(std::sin(-0.5 * phi), 0.0, std::cos(0.5 * phi)), n1(std::sin(0.5 * phi), 0.0, std::cos(0.5 * phi));
    const Vector3d p0 = rho * n0, d = rho * (n1 - n0);
    const double plain = rho - onEdge(p0, d, Vector3d::Zero(), 0.5).norm();
    EXPECT_NEAR(plain / (rho * phi * phi / 8.0), 1.0, 0.01) << phi;
    const double robust = onEdge(p0, d, robustBow(d, n0, n1), 0.5).norm() - rho;
    EXPECT_NEAR(std::abs(robust) / (rho * std::pow(phi, 4) / 128.0), 1.0, 0.01) << phi;
    // The published control point is where both tangents meet: the parabola through it is the same here, in one plane.
    EXPECT_NEAR((publishedBow(d, n0, n1) - robustBow(d, n0, n1)).norm(), 0.0, 1e-3 * plain) << phi;
  }
}

TEST(ParabolaEdge, OfAnInflectionIsNearlyStraight)
{
  // z = x^3: tangents at both ends have the same slope, the chord crosses the curve in the middle.
  constexpr double a = 0.2;
  const Vector3d p0(-a, 0.0, -a * a * a), d(2.0 * a, 0.0, 2.0 * a * a * a);
  const Vector3d n = Vector3d(-3.0 * a * a, 0.0, 1.0).normalized();
  EXPECT_LT(robustBow(d, n, n).norm(), 1e-12);
  EXPECT_EQ(publishedBow(d, n, n), Vector3d::Zero()); // planes that do not meet: straight
  // Nearly parallel tangents meet far away: the error of the published parabola is much larger than that of the straight edge.
  const Vector3d m = (n + Vector3d(1e-3, 0.0, 0.0)).normalized();
  const double largest = a * a * a * 2.0 / (3.0 * std::sqrt(3.0)); // of x^3 - a^2 x
  EXPECT_GT(publishedBow(d, n, m).norm() / 4.0, 5.0 * largest);
  EXPECT_LT(robustBow(d, n, m).norm() / 4.0, largest);
}

TEST(ParabolaEdge, HasNoBowWhereNormalsOppose)
{
  EXPECT_EQ(robustBow(Vector3d::UnitX(), Vector3d::UnitZ(), -Vector3d::UnitZ()), Vector3d::Zero());
  EXPECT_EQ(creaseBow(Vector3d::UnitX(), Vector3d::UnitZ(), Vector3d::UnitZ(), -Vector3d::UnitZ(), -Vector3d::UnitZ()), Vector3d::Zero());
}

TEST(ParabolaEdge, OfACreaseBowsInEachSurfaceAsThatSurfaceDoes)
{
  // Rim of a cylinder along z: its wall is curved, its cap is flat.
  constexpr double phi = 0.1, rho = 20.0;
  const Vector3d n0(std::cos(0.5 * phi), -std::sin(0.5 * phi), 0.0), n1(std::cos(0.5 * phi), std::sin(0.5 * phi), 0.0);
  const Vector3d d = rho * (n1 - n0);
  const Vector3d bow = creaseBow(d, n0, n1, Vector3d::UnitZ(), Vector3d::UnitZ());
  EXPECT_LT((bow - robustBow(d, n0, n1)).norm(), 1e-12);
  EXPECT_LT((creaseBow(d, Vector3d::UnitZ(), Vector3d::UnitZ(), n0, n1) - bow).norm(), 1e-12);
  // A cap inclined by 45 degrees: the edge stays in it and in the tangent planes of the wall.
  const Vector3d m = Vector3d(1.0, 0.0, 1.0).normalized();
  const Vector3d leaning = creaseBow(d, n0, n1, m, m);
  EXPECT_NEAR(leaning.dot(m), 0.0, 1e-12);
  EXPECT_NEAR(leaning.dot((n0 + n1).normalized()), robustBow(d, n0, n1).norm() * -1.0, 1e-12);
}

TEST(ParabolaEdge, CrossesALevelOnceAndInClosedForm)
{
  test::Random random(7);
  for (int i = 0; i < 10000; ++i) {
    const double v0 = random.uniform(-1.0, 0.0), v1 = random.uniform(0.0, 1.0), bow = random.uniform(-1.0, 1.0) * (i % 3);
    for (const bool falling : {false, true}) {
      const double a = falling ? v1 : v0, b = falling ? v0 : v1;
      const double u = parabolaCrossing(a, b, bow, 0.0);
      ASSERT_GE(u, 0.0);
      ASSERT_LE(u, 1.0);
      ASSERT_NEAR(a + (b - a) * u - bow * u * (1.0 - u), 0.0, 1e-12) << v0 << " " << v1 << " " << bow;
    }
  }
  EXPECT_DOUBLE_EQ(parabolaCrossing(-1.0, 1.0, 0.0, 0.0), 0.5);
  EXPECT_DOUBLE_EQ(parabolaCrossing(-1.0, 0.0, 0.3, 0.0), 1.0);
}

} // namespace parabola_edge_test
