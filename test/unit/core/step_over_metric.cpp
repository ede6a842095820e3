// SPDX-License-Identifier: BSD-3-Clause
// Lengths in step-overs, against the exact step-over of plane, sphere and cylinder.
#include <pcl_spiral/core/impl/step_over_metric.h>
#include <pcl_spiral/core/step_over.h>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>

namespace step_over_metric_test {

using namespace pcl_spiral;
using Eigen::Vector3d;

TEST(StepOverMetric, IsExactOnAPlaneInAnyPosition)
{
  const Vector3d normal = Vector3d(0.3, -0.5, 0.8).normalized(), direction = normal.unitOrthogonal();
  const StepOverMetric metric = stepOverMetric(normal, direction, 0.0, 0.0, 5.0, 0.1);
  const double step = *stepOver(5.0, 0.0, 0.1);
  for (double angle = 0.0; angle < 6.0; angle += 0.5) {
    const Vector3d d = std::cos(angle) * direction + std::sin(angle) * normal.cross(direction);
    EXPECT_NEAR(metric.length(step * d), 1.0, 1e-6);
  }
  EXPECT_NEAR(longestStepOver(metric), step, 1e-5);
}

TEST(StepOverMetric, FollowsTheCurvatureAcrossTheFeed)
{
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
  for (const double curvature : {0.02, 0.1, -0.05, -0.12}) {
    const StepOverMetric metric = stepOverMetric(z, x, curvature, 0.0, 5.0, 0.02); // a cylinder along y
    EXPECT_NEAR(metric.length(*stepOver(5.0, curvature, 0.02) * x), 1.0, 0.006) << curvature;
    EXPECT_NEAR(metric.length(*stepOver(5.0, 0.0, 0.02) * y), 1.0, 1e-6) << curvature;
  }
}

TEST(StepOverMetric, WhereTheBallHardlyFitsStepOversAreAtMostThoseOfATwentieth)
{
  const auto longest = [](double curvature) {
    return longestStepOver(stepOverMetric(Vector3d::UnitZ(), Vector3d::UnitX(), curvature, curvature, 5.0, 0.1));
  };
  const double flat = *stepOver(5.0, 0.0, 0.1);
  EXPECT_NEAR(longest(-0.19), flat / std::sqrt(0.05), 1e-3);  // 1 + R k = 0.05
  EXPECT_NEAR(longest(-0.2), flat / std::sqrt(0.05), 1e-3);   // as tight as the ball
  EXPECT_NEAR(longest(-0.205), flat / std::sqrt(0.05), 1e-3); // -0.025
  EXPECT_NEAR(longest(-0.3), flat / std::sqrt(0.5), 1e-3);    // -0.5: the ball rests on the sides
  EXPECT_NEAR(longest(-3.0), flat, 1e-3);                     // a crevice, as a plane
}

TEST(StepOverMetric, TheBoundOfTheLongestIsNearIt)
{
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Vector3d(0.3, -0.5, 0.8).normalized()).toRotationMatrix();
  for (const double scale : {1e-3, 1.0, 1e3})
    for (double b = 1.0; b < 500.0; b *= 1.3)
      for (double c = b; c < 500.0; c *= 1.3) {
        const StepOverMetric metric(Eigen::Matrix3d(scale * turn * Vector3d(1.0, b, c).asDiagonal() * turn.transpose()));
        const double exact = longestStepOver(metric), bound = longestStepOverBound(metric);
        ASSERT_GE(bound, exact * (1.0 - 1e-12)) << scale << ' ' << b << ' ' << c;
        ASSERT_LT(bound, exact * 1.1548) << scale << ' ' << b << ' ' << c;
      }
}

TEST(StepOverMetric, MeansAreWeighted)
{
  const StepOverMetric a(Eigen::Matrix3d::Identity()), b(Eigen::Matrix3d(4.0 * Eigen::Matrix3d::Identity()));
  EXPECT_NEAR(between(a, b, 0.25).squaredLength(Vector3d(1.0, 2.0, 2.0)), 9.0 * 1.75, 1e-5);
  EXPECT_TRUE(a.matrix().isApprox(Eigen::Matrix3d::Identity()));
}

} // namespace step_over_metric_test
