// SPDX-License-Identifier: BSD-3-Clause
// The time of turns that the choice of a method compares.
#include "core/turn_time.h"

#include <gtest/gtest.h>

#include <cmath>

namespace turn_time_test {

using namespace pcl_spiral;

TEST(TurnTime, WideTurnsRunAtTheFeedAndNarrowOnesByTheirAcceleration)
{
  const TurnPace slow{1000.0 / 60.0, 2000.0, 0.005, 5.0};
  EXPECT_NEAR(roundTime(slow, 50.0), 60.0 / 1000.0, 1e-3 * 60.0 / 1000.0);
  const TurnPace fast{10000.0 / 60.0, 200.0, 0.005, 5.0};
  const double most = std::sqrt(std::sqrt(0.75) * 200.0 * 20.0); // LinuxCNC's share of the acceleration towards the centre
  EXPECT_NEAR(roundTime(fast, 20.0), 1.0 / most, 0.05 / most);
}

TEST(TurnTime, ABendCostsMoreTheFasterAndTheSharperItIs)
{
  const auto cost = [](double feed, double radius) { return bendTime({feed / 60.0, 2000.0, 0.005, 5.0}, radius, 50.0); };
  EXPECT_NEAR(cost(500.0, 5.0), 0.0, 1e-3);
  EXPECT_GT(cost(3000.0, 0.5), cost(1000.0, 0.5));
  EXPECT_GT(cost(3000.0, 0.5), cost(3000.0, 2.0));
  EXPECT_LT(cost(3000.0, 0.5), 0.1);
}

} // namespace turn_time_test
