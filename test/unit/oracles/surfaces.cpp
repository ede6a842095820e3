// SPDX-License-Identifier: BSD-3-Clause
#include "support/surfaces.h"
#include "support/sampling.h"

#include <gtest/gtest.h>

#include <cmath>

namespace surfaces_test {

using namespace pcl_spiral::test;

namespace {

constexpr double pi = 3.14159265358979323846;

std::vector<std::pair<const char*, SurfacePtr>>
all()
{
  return {{"freeform", freeform()},
          {"dome", spheroidCap(1650, 860)},
          {"dome annulus", spheroidCap(1650, 860, 260)},
          {"cap", spheroidCap(80, 45)},
          {"bowl", bowl()},
          {"ball", ball(50, Region({circle({0, 0}, 30)}))},
          {"cylinder", cylinder(50, Region({rectangle(60, 100)}))},
          {"saddle", ovalSaddle()},
          {"annulus", offCentreAnnulus()},
          {"kidney", kidneyPatch()},
          {"L", ellPatch()},
          {"ground", ground({6.0, 45.0, 50.0, 0.002, -0.001}, Region({rectangle(200, 150)}))}};
}

} // namespace

TEST(Surfaces, FreeformHasTheReliefAndTheSmallestRadiusAsked)
{
  const SurfacePtr surface = freeform();
  double low = 1e9, high = -1e9, curvature = 0.0;
  for (int i = 0; i <= 400; ++i)
    for (int j = 0; j <= 400; ++j) {
      const Eigen::Vector3d x = surface->lift({-500 + 2.5 * i, -500 + 2.5 * j});
      const auto [least, most] = surface->principalCurvatures(x);
      low = std::min(low, x.z());
      high = std::max(high, x.z());
      curvature = std::max({curvature, most, -least});
    }
  EXPECT_NEAR(high - low, 450.0, 5.0);
  EXPECT_NEAR(1.0 / curvature, 300.0, 5.0);
}

TEST(Surfaces, DerivativesAgreeWithDifferences)
{
  Random random(3);
  for (const auto& [name, surface] : all())
    for (int i = 0; i < 50; ++i) {
      const Sampled at = sampleUniform(*surface, 1, 100 + i);
      const Eigen::Vector3d x = at.points[0] + random.uniform(-1, 1) * at.normals[0];
      const double h = 1e-4;
      for (int k = 0; k < 3; ++k) {
        const Eigen::Vector3d e = h * Eigen::Vector3d::Unit(k);
        EXPECT_NEAR((surface->value(x + e) - surface->value(x - e)) / (2 * h), surface->gradient(x)[k], 1e-6) << name;
        const Eigen::Vector3d column = (surface->gradient(x + e) - surface->gradient(x - e)) / (2 * h);
        EXPECT_LT((column - surface->hessian(x).col(k)).norm(), 1e-7) << name;
      }
    }
}

TEST(Surfaces, ClosestPointUndoesAMoveAlongTheNormal)
{
  Random random(4);
  for (const auto& [name, surface] : all()) {
    const Sampled samples = sampleUniform(*surface, 300, 5);
    for (std::size_t i = 0; i < samples.points.size(); ++i) {
      const double t = random.uniform(-5, 15);
      const Eigen::Vector3d p = samples.points[i] + t * samples.normals[i];
      EXPECT_LT((surface->closest(p) - samples.points[i]).norm(), 1e-9) << name;
      EXPECT_NEAR(surface->signedDistance(p), t, 1e-9) << name;
      EXPECT_TRUE(surface->contains(samples.points[i])) << name;
      EXPECT_LT((surface->lift(surface->chart(samples.points[i])) - samples.points[i]).norm(), 1e-9) << name;
    }
  }
}

TEST(Surfaces, NormalsPointToTheCutterAndConvexIsPositive)
{
  EXPECT_LT((bowl()->normal({0, 0, -130}) - Eigen::Vector3d(0, 0, 1)).norm(), 1e-15);
  EXPECT_NEAR(bowl()->normalCurvature({0, 0, -130}, {1, 0, 0}), -1.0 / 130, 1e-15);
  EXPECT_NEAR(spheroidCap(1650, 860)->normalCurvature({1650, 0, 0}, {0, 0, 1}), 1650 / (860.0 * 860), 1e-15);
  EXPECT_NEAR(spheroidCap(1650, 860)->normalCurvature({1650, 0, 0}, {0, 1, 0}), 1 / 1650.0, 1e-15);
  const auto [least, most] = cylinder(50, Region({rectangle(60, 100)}))->principalCurvatures({0, 0, 50});
  EXPECT_NEAR(least, 0.0, 1e-15);
  EXPECT_NEAR(most, 0.02, 1e-15);
  EXPECT_NEAR(ovalSaddle()->normalCurvature({0, 0, 0}, {1, 0, 0}), -1 / 250.0, 1e-15);
}

TEST(Surfaces, AreasAndOutlinesAreExact)
{
  const double a = 1650, b = 860, e = std::sqrt(1 - b * b / (a * a));
  const double dome = pi * a * a * (1 + (1 - e * e) / e * std::atanh(e));
  EXPECT_NEAR(spheroidCap(a, b)->area() / dome, 1.0, 1e-4);
  EXPECT_NEAR(bowl()->area() / (2 * pi * 130 * (130 - std::sqrt(130.0 * 130 - 100 * 100))), 1.0, 1e-4);
  EXPECT_NEAR(ellPatch()->region().integrate([](const Eigen::Vector2d&) { return 1.0; }), 200 * 200 - 110 * 110, 40.0);
  const SurfacePtr annulus = spheroidCap(a, b, 260);
  ASSERT_EQ(annulus->outlines().size(), 2u);
  EXPECT_NEAR(pcl_spiral::length(annulus->outlines()[0], true), 2 * pi * a, 1e-2);
  EXPECT_NEAR(pcl_spiral::length(annulus->outlines()[1], true), 2 * pi * 260, 1e-2);
}

TEST(Surfaces, RimDistanceIsExactAtASquareAndACircle)
{
  const SurfacePtr square = flat(Region({rectangle(100, 60)}));
  const SurfacePtr dome = spheroidCap(1650, 860, 260);
  Random random(6);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d x(random.uniform(-50, 50), random.uniform(-30, 30), 0);
    EXPECT_NEAR(square->rimDistance(x), std::min(50 - std::abs(x.x()), 30 - std::abs(x.y())), 1e-12);
    const Eigen::Vector3d p = sampleUniform(*dome, 1, 50 + i).points[0];
    const double r = p.head<2>().norm(), z_hole = 860 * std::sqrt(1 - 260.0 * 260 / (1650.0 * 1650));
    EXPECT_NEAR(dome->rimDistance(p), std::min(std::hypot(1650 - r, p.z()), std::hypot(r - 260, p.z() - z_hole)), 2e-3);
  }
}

TEST(Surfaces, SamplesAreUniformByAreaAndRepeat)
{
  const SurfacePtr dome = spheroidCap(1650, 860);
  const Sampled samples = sampleUniform(*dome, 40000, 7);
  std::size_t above = 0;
  for (const Eigen::Vector3d& p : samples.points)
    above += p.z() > 430 ? 1 : 0;
  const SurfacePtr top = spheroidCap(1650, 860, 1650 * std::sqrt(0.75));
  const double share = 1.0 - top->area() / dome->area();
  EXPECT_NEAR(static_cast<double>(above) / 40000, share, 4 * std::sqrt(share * (1 - share) / 40000));
  const Sampled again = sampleUniform(*dome, 40000, 7);
  EXPECT_EQ(samples.points.back(), again.points.back());
  EXPECT_NE(samples.points.back(), sampleUniform(*dome, 40000, 8).points.back());
}

TEST(Surfaces, ScanLinesAndNoiseAreAsAsked)
{
  const SurfacePtr plane = flat(Region({rectangle(100, 60)}));
  Sampled lines = sampleScanLines(*plane, 0.5, 5.0, 9, 0.0);
  EXPECT_NEAR(static_cast<double>(lines.points.size()), 200 * 12, 220);
  addNoise(lines, 0.02, 10);
  double sum = 0.0, square = 0.0;
  for (const Eigen::Vector3d& p : lines.points) {
    sum += p.z();
    square += p.z() * p.z();
  }
  const double n = static_cast<double>(lines.points.size());
  EXPECT_NEAR(std::sqrt(square / n), 0.02, 0.0012);
  EXPECT_NEAR(sum / n, 0.0, 0.002);
  const Eigen::Isometry3d motion = randomMotion(11, 100);
  EXPECT_NEAR(motion.linear().determinant(), 1.0, 1e-12);
}

} // namespace surfaces_test
