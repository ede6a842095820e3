// SPDX-License-Identifier: BSD-3-Clause
// The noise of points is told from the shape that wide fits miss.
#include "planning/point_noise.h"

#include "support/sampling.h"

#include <gtest/gtest.h>

#include <cmath>

namespace point_noise_test {
namespace {

using namespace pcl_spiral;

/** Points of a wave of length \p wave, 2 mm from top to bottom, with \p noise, \p spacing apart. */
std::vector<Eigen::Vector3f>
waveScan(double wave, double spacing, double noise)
{
  test::Random random(11);
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < 30; ++i)
    for (int k = 0; k < 30; ++k) {
      const double x = spacing * (i + random.uniform(-0.2, 0.2)), y = spacing * (k + random.uniform(-0.2, 0.2));
      points.emplace_back(static_cast<float>(x), static_cast<float>(y),
                          static_cast<float>(std::sin(2.0 * M_PI * x / wave) + noise * random.normal()));
    }
  return points;
}

} // namespace

TEST(PointNoise, IsThatOfThePoints)
{
  for (const double noise : {0.01, 0.05, 0.3})
    EXPECT_NEAR(pointNoise(waveScan(60.0, 0.8, noise)), noise, 0.1 * noise);
}

/** With eight points in a wave, 32 of them span most of it, and no quadric follows it. */
TEST(PointNoise, HasLittleOfTheShapeOfACoarseScan)
{
  EXPECT_LT(pointNoise(waveScan(8.0 * 5.0, 5.0, 0.0)), 0.05);
  EXPECT_NEAR(pointNoise(waveScan(8.0 * 5.0, 5.0, 0.1)), 0.1, 0.03);
}

TEST(PointNoise, OfFewPointsIsNotKnown)
{
  EXPECT_EQ(pointNoise({}), 0.0);
  EXPECT_EQ(pointNoise({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), 0.0);
}

} // namespace point_noise_test
