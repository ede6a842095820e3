// SPDX-License-Identifier: BSD-3-Clause
// Step-over from the cutter's profile, against ridges found by a search over the distance of two passes.
#include <pcl_spiral/core/cutter_profile.h>

#include "support/cutters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace profile_step_test {

using namespace pcl_spiral;

namespace {

/** Height left between two passes: the maximum of the lower cutter at each place, in small steps. */
double
ridge(const CutterProfile& cutter, double step)
{
  double highest = 0.0;
  for (int i = 0; i <= 4000; ++i) {
    const double x = step * i / 4000;
    highest = std::max(highest, std::min(cutter.height(x), cutter.height(step - x)));
  }
  return highest;
}

} // namespace

TEST(ProfileStep, LeavesRidgesOfTheScallopAndNoWiderStepDoes)
{
  test::Random random(7);
  int reached = 0;
  for (int i = 0; i < 500; ++i) {
    const CutterProfile cutter(test::randomCutter(random));
    const double scallop = random.uniform(0.001, 0.5) * cutter.radius();
    const double step = stepForScallop(cutter, scallop).value();
    ASSERT_LE(step, 2.0 * cutter.radius());
    ASSERT_LE(ridge(cutter, step * (1.0 - 1e-9)), scallop * (1.0 + 1e-6));
    if (step < 2.0 * cutter.radius()) {
      ASSERT_GT(ridge(cutter, 1.001 * step), scallop);
      ++reached;
    }
  }
  EXPECT_GT(reached, 250);
}

TEST(ProfileStep, IsThatOfTheFormulasForBallBullNoseAndFlatEnd)
{
  EXPECT_NEAR(*stepForScallop(CutterProfile(CutterShape::ball(10.0)), 0.05), 2.0 * std::sqrt(100.0 - 9.95 * 9.95), 1e-12);
  EXPECT_NEAR(*stepForScallop(CutterProfile(CutterShape::bullNose(8.0, 2.0, 5.0)), 0.1), 12.0 + 2.0 * std::sqrt(4.0 - 1.9 * 1.9), 1e-12);
  EXPECT_EQ(*stepForScallop(CutterProfile(CutterShape::flatEnd(6.0, 5.0)), 0.1), 12.0);
  EXPECT_EQ(*stepForScallop(CutterProfile(CutterShape::ball(3.0)), 30.0), 6.0);
  const CutterProfile ball(CutterShape::ball(10.0));
  EXPECT_FALSE(stepForScallop(ball, 0.0));
  EXPECT_FALSE(stepForScallop(ball, -1.0));
  EXPECT_FALSE(stepForScallop(ball, std::numeric_limits<double>::quiet_NaN()));
}

} // namespace profile_step_test
