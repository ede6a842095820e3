// SPDX-License-Identifier: BSD-3-Clause
// Planted self-crossings are found at their places; a spiral has none.
#include "core/self_crossing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace self_crossing_test {

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

TEST(SelfCrossing, ALiftCrossesNothing)
{
  auto path = spiral(4000);
  const std::size_t begin = path.size();
  for (int i = 0; i < 10; ++i) // a separate pass, from the other side of all turns
    path.push_back({-205.0 - i, 0.0, 39.0});
  const std::vector<Eigen::Vector3d> normals(path.size(), Eigen::Vector3d::UnitZ());
  EXPECT_TRUE(pcl_spiral::firstSelfCrossing(path, normals));
  EXPECT_FALSE(pcl_spiral::firstSelfCrossing(path, normals, 0.0, {}, {begin}));
  path.push_back({-190.0, 0.1, 36.1});
  EXPECT_TRUE(pcl_spiral::firstSelfCrossing(path, normals, 0.0, {}, {begin})); // but the pass after it does
}

TEST(SelfCrossing, ALongSearchIsEndedOnTheWay)
{
  pcl_spiral::Polyline zigzag;
  for (int i = 0; i < 300000; ++i)
    zigzag.push_back({i % 2 == 0 ? 0.0 : 1.0, 1e-2 * i, 0.0});
  zigzag.push_back({0.5, 2990.0, 0.0}); // back over the last part
  const std::vector<Eigen::Vector3d> normals(zigzag.size(), Eigen::Vector3d::UnitZ());
  std::vector<double> shares;
  const auto all = [&](double share) {
    shares.push_back(share);
    return true;
  };
  const auto found = pcl_spiral::firstSelfCrossing(zigzag, normals, 0.0, all);
  ASSERT_TRUE(found);
  EXPECT_GT(*found, 290000U);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_GE(shares.size(), 4U);
  EXPECT_LE(shares.back(), 1.0);
  int asked = 0;
  EXPECT_FALSE(pcl_spiral::firstSelfCrossing(zigzag, normals, 0.0, [&](double) { return ++asked < 3; }));
  EXPECT_EQ(asked, 3);
}

TEST(SelfCrossing, ShortPathsAndRepeatedPoints)
{
  const pcl_spiral::Polyline still(5, Eigen::Vector3d(1, 2, 3));
  EXPECT_FALSE(pcl_spiral::firstSelfCrossing(still, {5, Eigen::Vector3d::UnitZ()}));
  EXPECT_FALSE(pcl_spiral::firstSelfCrossing({}, {}));
}

// Whether two segments of the plane z = 0 cross: each has the ends of the other on different sides, by more than the slack.
bool
crossInPlane(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& d, double slack)
{
  const auto offSides = [slack](const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Eigen::Vector3d& r, const Eigen::Vector3d& s) {
    const Eigen::Vector2d across = Eigen::Vector2d(p.y() - q.y(), q.x() - p.x()).normalized();
    const double one = across.dot((r - p).head<2>()), other = across.dot((s - p).head<2>());
    return (one > slack && other < -slack) || (one < -slack && other > slack);
  };
  return offSides(a, b, c, d) && offSides(c, d, a, b);
}

TEST(SelfCrossing, AgreesWithEveryPairTested)
{
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> u(-1.0, 1.0);
  int crossed = 0;
  for (int trial = 0; trial < 300; ++trial) {
    // A path that drifts, so that some paths cross late and some never.
    pcl_spiral::Polyline path{Eigen::Vector3d(1000 * u(random), 1000 * u(random), 0)};
    for (int i = 0; i < 60; ++i)
      path.push_back(path.back() + Eigen::Vector3d(0.9 + u(random), 1.5 * u(random), 0));
    const double slack = trial % 2 ? 0.05 : 0.0;
    std::optional<std::size_t> expected;
    for (std::size_t i = 0; i + 1 < path.size() && !expected; ++i)
      for (std::size_t j = i + 2; j + 1 < path.size(); ++j)
        if (crossInPlane(path[i], path[i + 1], path[j], path[j + 1], slack))
          expected = i;
    crossed += expected.has_value();
    EXPECT_EQ(pcl_spiral::firstSelfCrossing(path, {path.size(), Eigen::Vector3d::UnitZ()}, slack), expected) << trial;
  }
  EXPECT_GT(crossed, 30);
  EXPECT_LT(crossed, 250);
}

TEST(SelfCrossing, SegmentsMayPassOverEachOther)
{
  // A loop that crosses its start at some height above it.
  const auto loop = [](double height) {
    pcl_spiral::Polyline path;
    for (int i = 0; i <= 20; ++i)
      path.emplace_back(i, 0.0, 0.0);
    for (int i = 1; i <= 10; ++i)
      path.emplace_back(20.0, i, 0.1 * i * height);
    for (int i = 1; i <= 10; ++i)
      path.emplace_back(20.0 - i, 10.0, height);
    for (int i = 1; i <= 20; ++i)
      path.emplace_back(9.6, 10.3 - i, height);
    return path;
  };
  for (double height : {-0.14, 0.0, 0.14, -3.2, 3.2}) {
    const auto path = loop(height);
    const auto found = pcl_spiral::firstSelfCrossing(path, {path.size(), Eigen::Vector3d::UnitZ()});
    EXPECT_EQ(found.has_value(), std::abs(height) < 1.0) << height;
    if (found)
      EXPECT_EQ(*found, 9u);
  }
}

} // namespace

} // namespace self_crossing_test
