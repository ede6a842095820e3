// SPDX-License-Identifier: BSD-3-Clause
// Ridges along a path against a search through all points.
#include "verify/path_ridges.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace path_ridges_test {

using namespace pcl_spiral;

namespace {

constexpr float none = std::numeric_limits<float>::quiet_NaN();

/** Points of a wavy surface with a ridge height each; some have no stock, some no ridge. */
struct Measured {
  pcl::PointCloud<pcl::PointXYZI> stock;
  std::vector<float> ridges;
  pcl::PointCloud<ToolpathPoint> path;
};

Measured
measured(std::uint32_t seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> side(-50.0f, 50.0f), share(0.0f, 1.0f);
  Measured m;
  for (int i = 0; i < 3000; ++i) {
    pcl::PointXYZI p;
    p.x = side(random);
    p.y = side(random);
    p.z = 3.0f * std::sin(0.1f * p.x);
    p.intensity = share(random) < 0.3f ? none : 0.01f * share(random);
    m.stock.push_back(p);
    m.ridges.push_back(share(random) < 0.1f ? none : 0.1f * share(random));
  }
  for (int i = 0; i < 400; ++i) {
    ToolpathPoint p;
    p.x = side(random);
    p.y = side(random);
    p.z = 3.0f * std::sin(0.1f * p.x) + share(random);
    m.path.push_back(p);
  }
  return m;
}

/** The number of the nearest point that \p counts. */
template <typename Counts>
std::size_t
nearestOf(const pcl::PointCloud<pcl::PointXYZI>& points, const ToolpathPoint& place, Counts counts)
{
  std::size_t nearest = points.size();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double distance = (points[i].getVector3fMap().cast<double>() - place.getVector3fMap().cast<double>()).norm();
    if (counts(i) && distance < least) {
      least = distance;
      nearest = i;
    }
  }
  return nearest;
}

} // namespace

TEST(PathRidges, AreThoseOfTheNearestPointWithAStock)
{
  std::size_t beside_others = 0, without = 0;
  for (const std::uint32_t seed : {1U, 2U, 3U}) {
    const Measured m = measured(seed);
    const std::vector<float> found = ridgesAlong(m.path, m.stock, m.ridges);
    ASSERT_EQ(found.size(), m.path.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      const std::size_t nearest = nearestOf(m.stock, m.path[i], [&](std::size_t k) { return !std::isnan(m.stock[k].intensity); });
      if (std::isnan(m.ridges[nearest]))
        EXPECT_TRUE(std::isnan(found[i])) << "seed " << seed << ", path point " << i;
      else
        EXPECT_EQ(found[i], m.ridges[nearest]) << "seed " << seed << ", path point " << i;
      without += std::isnan(found[i]);
      beside_others += nearest != nearestOf(m.stock, m.path[i], [](std::size_t) { return true; });
    }
  }
  EXPECT_GT(beside_others, 100U) << "points without a stock are nearer";
  EXPECT_GT(without, 30U);
}

TEST(PathRidges, AreNoneWhereNothingWasMeasured)
{
  Measured m = measured(4);
  for (pcl::PointXYZI& point : m.stock)
    point.intensity = none;
  for (const float ridge : ridgesAlong(m.path, m.stock, m.ridges))
    EXPECT_TRUE(std::isnan(ridge));
  EXPECT_EQ(ridgesAlong(m.path, {}, {}).size(), m.path.size());
  EXPECT_TRUE(ridgesAlong({}, m.stock, m.ridges).empty());
}

} // namespace path_ridges_test
