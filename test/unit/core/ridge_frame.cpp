// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/core/impl/ridge_frame.h>

#include "support/sampling.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>

namespace ridge_frame_test {

using namespace pcl_spiral;
using Eigen::Vector3d;

namespace {

constexpr double degree = M_PI / 180.0;

Vector3d
randomDirection(test::Random& random)
{
  return Vector3d(random.normal(), random.normal(), random.normal()).normalized();
}

} // namespace

TEST(RidgeFrame, IsRightHandedAndKeepsTheAngle)
{
  test::Random random(1);
  int refused = 0;
  for (int k = 0; k < 2000; ++k) {
    const Vector3d tangent = randomDirection(random), reference = randomDirection(random);
    const RidgeChord chord{reference, std::sin(random.uniform(-1.5, 1.5)), k % 2 == 0 ? 1 : -1};
    const auto frame = ridgeFrame(tangent, chord);
    const double slope = std::asin(std::abs(tangent.dot(reference)));
    ASSERT_EQ(frame.has_value(), std::abs(chord.sin_angle) < std::cos(slope));
    if (!frame) {
      ++refused;
      continue;
    }
    EXPECT_NEAR(frame->chord.norm(), 1.0, 1e-12);
    EXPECT_NEAR(frame->chord.dot(tangent), 0.0, 1e-12);
    EXPECT_NEAR(frame->chord.dot(reference), chord.sin_angle, 1e-12);
    EXPECT_NEAR((tangent.cross(frame->chord) - frame->up).norm(), 0.0, 1e-12);
    EXPECT_GT(chord.branch * frame->up.dot(reference), 0.0);
    const RidgeChord back = ridgeChord(tangent, frame->chord, reference);
    EXPECT_NEAR(back.sin_angle, chord.sin_angle, 1e-12);
    EXPECT_EQ(back.branch, chord.branch);
  }
  EXPECT_GT(refused, 300);
}

TEST(RidgeFrame, TellsHowFarAnErrorOfTheSlopeTurnsTheChord)
{
  const auto at = [](double slope) { return ridgeFrame({std::cos(slope), 0.0, std::sin(slope)}, {Vector3d::UnitZ(), 0.5, 1}); };
  EXPECT_NEAR(at(59.5 * degree)->slopeFactor(), 9.7, 0.05);
  const double slope = 50.0 * degree, change = 1e-6;
  const double turned = std::asin(at(slope + change)->sin_psi) - std::asin(at(slope)->sin_psi);
  EXPECT_NEAR(at(slope)->slopeFactor(), turned / change, 1e-4);
  EXPECT_FALSE(at(60.5 * degree));
  EXPECT_FALSE(ridgeFrame(Vector3d::UnitZ(), {Vector3d::UnitZ(), 0.0, 1}));
}

TEST(RidgeFrame, TurnsAsFiniteDifferencesSay)
{
  // Along a curve with a different slope at every place.
  const auto tangentAt = [](double s) {
    return Vector3d(std::cos(0.3 * s), std::sin(0.3 * s), 0.4 * std::sin(0.2 * s) + 0.1).normalized();
  };
  const Vector3d reference = Vector3d(0.1, -0.2, 1.0).normalized();
  for (double s = 0.0; s < 20.0; s += 0.37)
    for (const int branch : {1, -1}) {
      const RidgeChord chord{reference, std::sin(-15.0 * degree), branch};
      const double d = 1e-5;
      const auto before = ridgeFrame(tangentAt(s - d), chord), frame = ridgeFrame(tangentAt(s), chord),
                 after = ridgeFrame(tangentAt(s + d), chord);
      const Vector3d omega = ridgeTurn(*frame, (tangentAt(s + d) - tangentAt(s - d)) / (2.0 * d), reference);
      const Vector3d chord_change = (after->chord - before->chord) / (2.0 * d), up_change = (after->up - before->up) / (2.0 * d);
      EXPECT_NEAR((frame->localOf(chord_change) - omega.cross(Vector3d::UnitY())).norm(), 0.0, 1e-8);
      EXPECT_NEAR((frame->localOf(up_change) - omega.cross(Vector3d::UnitZ())).norm(), 0.0, 1e-8);
    }
}

} // namespace ridge_frame_test
