// Self-crossings put in on purpose are found where they are; a spiral has none.
#include <pcl_spiral/core/self_crossing.h>

#include <gtest/gtest.h>

#include <cmath>

namespace {

pcl_spiral::Polyline
spiral(int points)
{
  pcl_spiral::Polyline path;
  for (int i = 0; i < points; ++i) {
    const double a = 0.05 * i;
    path.emplace_back(a * std::cos(a), a * std::sin(a), 0.001 * a * a);
  }
  return path;
}

TEST(SelfCrossing, SpiralHasNone)
{
  const auto path = spiral(4000);
  EXPECT_FALSE(pcl_spiral::firstSelfCrossing(path, {path.size(), Eigen::Vector3d::UnitZ()}));
}

TEST(SelfCrossing, FindsThePointThatLeavesItsTurn)
{
  auto path = spiral(4000);
  path[2000] *= 1.0 + 1.05 * 2.0 * M_PI / (0.05 * 2000); // just over the next turn
  const auto found = pcl_spiral::firstSelfCrossing(path, {path.size(), Eigen::Vector3d::UnitZ()});
  ASSERT_TRUE(found);
  EXPECT_NEAR(static_cast<double>(*found), 1999.5, 1.0);
}

TEST(SelfCrossing, ShortPathsAndRepeatedPoints)
{
  const pcl_spiral::Polyline still(5, Eigen::Vector3d(1, 2, 3));
  EXPECT_FALSE(pcl_spiral::firstSelfCrossing(still, {5, Eigen::Vector3d::UnitZ()}));
  EXPECT_FALSE(pcl_spiral::firstSelfCrossing({}, {}));
}

} // namespace
