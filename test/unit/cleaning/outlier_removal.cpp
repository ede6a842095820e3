// SPDX-License-Identifier: BSD-3-Clause
// Outliers are removed, the surface stays: against points of known kind.
#include <pcl_spiral/cleaning/outlier_removal.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

namespace outlier_removal_test {

using namespace pcl_spiral;

namespace {

constexpr std::size_t honest = 8000, outliers = 60;

/** A wave with a point about every mm, then outliers 2 to 30 mm off it. */
pcl::PointCloud<pcl::PointXYZ>::Ptr
scan(std::uint32_t seed = 1)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> side(-45.0f, 45.0f), off(2.0f, 30.0f);
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  for (std::size_t i = 0; i < honest + outliers; ++i) {
    const float x = side(random), y = side(random);
    const float above = i < honest ? 0.0f : (i % 2 == 0 ? 1.0f : -1.0f) * off(random);
    cloud->push_back({x, y, 4.0f * std::sin(0.07f * x) * std::cos(0.05f * y) + above});
  }
  return cloud;
}

pcl::Indices
kept(OutlierRemoval<pcl::PointXYZ>& removal, const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& cloud)
{
  removal.setInputCloud(cloud);
  pcl::Indices indices;
  removal.filter(indices);
  return indices;
}

} // namespace

TEST(OutlierRemoval, TakesOutliersAndKeepsTheSurface)
{
  OutlierRemoval<pcl::PointXYZ> removal(true);
  const pcl::Indices stay = kept(removal, scan());
  ASSERT_TRUE(removal.getStatus().ok()) << removal.getStatus().message();
  EXPECT_TRUE(std::is_sorted(stay.begin(), stay.end()));
  std::size_t left = 0;
  for (const auto i : stay)
    left += static_cast<std::size_t>(i) >= honest;
  EXPECT_EQ(left, 0U) << "outliers that stayed";
  EXPECT_GE(stay.size(), honest - 8) << "one in a thousand, of the rim, may go with them";
  pcl::Indices all = stay, gone = *removal.getRemovedIndices();
  all.insert(all.end(), gone.begin(), gone.end());
  std::sort(all.begin(), all.end());
  ASSERT_EQ(all.size(), honest + outliers);
  for (std::size_t i = 0; i < all.size(); ++i)
    ASSERT_EQ(static_cast<std::size_t>(all[i]), i);

  OutlierRemoval<pcl::PointXYZ> turned(true);
  turned.setNegative(true);
  EXPECT_EQ(kept(turned, scan()), gone);
  EXPECT_EQ(*turned.getRemovedIndices(), stay);
}

TEST(OutlierRemoval, RepetitionsAndNotANumberGoWithTheirKind)
{
  const auto cloud = scan();
  cloud->push_back((*cloud)[honest + 3]); // a duplicate of an outlier
  cloud->push_back((*cloud)[5]);          // a duplicate of a surface point
  const float nan = std::numeric_limits<float>::quiet_NaN();
  cloud->push_back({nan, nan, nan});
  cloud->is_dense = false;
  OutlierRemoval<pcl::PointXYZ> removal;
  const pcl::Indices stay = kept(removal, cloud);
  const std::set<pcl::index_t> found(stay.begin(), stay.end());
  EXPECT_EQ(found.count(honest + outliers), 0U);
  EXPECT_EQ(found.count(honest + outliers + 1), found.count(5));
  EXPECT_EQ(found.count(honest + outliers + 2), 0U);
}

TEST(OutlierRemoval, ChoosesTheSameInAnyOrderAndAmongIndices)
{
  const auto cloud = scan();
  OutlierRemoval<pcl::PointXYZ> removal;
  const pcl::Indices stay = kept(removal, cloud);
  pcl::PointCloud<pcl::PointXYZ>::Ptr turned(new pcl::PointCloud<pcl::PointXYZ>(*cloud));
  std::reverse(turned->begin(), turned->end());
  pcl::Indices back = kept(removal, turned);
  for (auto& i : back)
    i = static_cast<pcl::index_t>(cloud->size()) - 1 - i;
  std::reverse(back.begin(), back.end());
  EXPECT_EQ(back, stay);

  const pcl::IndicesPtr some(new pcl::Indices);
  for (std::size_t i = 0; i < cloud->size(); ++i)
    if ((*cloud)[i].x < 0.0f)
      some->push_back(static_cast<pcl::index_t>(i));
  OutlierRemoval<pcl::PointXYZ> among;
  among.setIndices(some);
  const pcl::Indices half = kept(among, cloud);
  EXPECT_TRUE(std::includes(some->begin(), some->end(), half.begin(), half.end()));
  EXPECT_FALSE(std::any_of(half.begin(), half.end(), [](auto i) { return static_cast<std::size_t>(i) >= honest; }));
  EXPECT_GT(half.size(), honest / 2 - 200);
}

/** High over the surface the nearest neighbours of outliers are other outliers, and they make triangles. */
TEST(OutlierRemoval, TakesSparseEchoesHighOverACap)
{
  for (std::uint32_t seed = 1; seed <= 4; ++seed)
    for (const int echoes : {20, 150, 380}) {
      std::mt19937 random(seed);
      std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
      pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
      while (cloud->size() < 20000) {
        const float x = 40.0f * unit(random), y = 40.0f * unit(random);
        if (x * x + y * y <= 1600.0f)
          cloud->push_back({x, y, std::sqrt(1e4f - x * x - y * y) - 100.0f});
      }
      for (int i = 0; i < echoes; ++i)
        cloud->push_back({40.0f * unit(random), 40.0f * unit(random), 25.0f + 15.0f * unit(random)});
      OutlierRemoval<pcl::PointXYZ> removal;
      const pcl::Indices stay = kept(removal, cloud);
      ASSERT_TRUE(removal.getStatus().ok()) << removal.getStatus().message();
      const auto left = std::count_if(stay.begin(), stay.end(), [](auto i) { return i >= 20000; });
      EXPECT_EQ(left, 0) << echoes << " echoes, seed " << seed;
      EXPECT_GE(stay.size() - static_cast<std::size_t>(left), 19980U);
    }
}

/** Far beyond an end of a column one triangle may join an outlier to the rim. */
TEST(OutlierRemoval, TakesAnEchoBeyondEachEndOfAColumn)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
  for (int round = 0; round < 10; ++round) {
    pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
    for (int i = 0; i < 12000; ++i) {
      const float angle = static_cast<float>(M_PI) * unit(random);
      cloud->push_back({20.0f * std::cos(angle), 20.0f * std::sin(angle), 18.0f * unit(random)});
    }
    for (const float side : {-1.0f, 1.0f})
      cloud->push_back({6.0f * unit(random), 6.0f * unit(random), side * (55.0f + 30.0f * unit(random))});
    OutlierRemoval<pcl::PointXYZ> removal;
    const pcl::Indices stay = kept(removal, cloud);
    EXPECT_EQ(std::count_if(stay.begin(), stay.end(), [](auto i) { return i >= 12000; }), 0) << round;
    EXPECT_GE(stay.size(), 11980U);
  }
}

/** Two to four outliers beyond the rim of a dense scan hang on it in long triangles that they share. */
TEST(OutlierRemoval, TakesEchoesThatHangTogetherOnARim)
{
  constexpr int dense = 60000;
  for (const std::uint32_t seed : {1u, 2u, 3u, 6u, 11u}) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
    pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
    while (cloud->size() < dense) {
      const float x = 40.0f * unit(random), y = 40.0f * unit(random);
      if (x * x + y * y <= 1600.0f)
        cloud->push_back({x, y, std::sqrt(1e4f - x * x - y * y) - 100.0f});
    }
    const float angle = static_cast<float>(M_PI) * unit(random);
    for (std::uint32_t i = 0; i < 2 + seed % 3; ++i)
      cloud->push_back(
          {41.0f * std::cos(angle) + 1.5f * unit(random), 41.0f * std::sin(angle) + 1.5f * unit(random), -14.0f + 3.0f * unit(random)});
    OutlierRemoval<pcl::PointXYZ> removal;
    const pcl::Indices stay = kept(removal, cloud);
    ASSERT_TRUE(removal.getStatus().ok()) << removal.getStatus().message();
    EXPECT_EQ(std::count_if(stay.begin(), stay.end(), [](auto i) { return i >= dense; }), 0) << "seed " << seed;
    EXPECT_GE(stay.size(), dense - 5U);
  }
}

/** A part that was scanned eight times as coarsely along its rim, three points wide, keeps these points. */
TEST(OutlierRemoval, KeepsASparserRim)
{
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  for (int i = -150; i <= 150; ++i)
    for (int k = -150; k <= 150; ++k)
      cloud->push_back({0.2f * static_cast<float>(i), 0.2f * static_cast<float>(k), 0.0f});
  const auto inside = static_cast<pcl::index_t>(cloud->size());
  for (int row = 1; row <= 3; ++row)
    for (int k = -18; k <= 18; ++k)
      cloud->push_back({30.0f + 1.6f * static_cast<float>(row), 1.6f * static_cast<float>(k), 0.0f});
  OutlierRemoval<pcl::PointXYZ> removal;
  const pcl::Indices stay = kept(removal, cloud);
  EXPECT_EQ(std::count_if(stay.begin(), stay.end(), [&](auto i) { return i >= inside; }), 3 * 37);
}

/** Outliers are single; ten points within 4 mm are an object. */
TEST(OutlierRemoval, GroupsStayWhereAsked)
{
  constexpr std::size_t together = 10;
  const auto cloud = scan();
  std::mt19937 random(9);
  std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
  for (std::size_t i = 0; i < together; ++i)
    cloud->push_back({10.0f + 2.0f * unit(random), -5.0f + 2.0f * unit(random), 14.0f + 0.5f * unit(random)});
  OutlierRemoval<pcl::PointXYZ> all;
  const pcl::Indices without = kept(all, cloud);
  const auto isThing = [](auto i) { return static_cast<std::size_t>(i) >= honest + outliers; };
  EXPECT_EQ(std::count_if(without.begin(), without.end(), isThing), 0);
  EXPECT_GE(all.getReport().largest_group, together);
  EXPECT_LT((all.getReport().largest_group_place - Eigen::Vector3d(10, -5, 14)).norm(), 2.0);
  EXPECT_EQ(all.getReport().outliers, cloud->size() - without.size());
  OutlierRemoval<pcl::PointXYZ> echoes;
  echoes.setLargestGroup(3);
  const pcl::Indices with = kept(echoes, cloud);
  EXPECT_EQ(std::count_if(with.begin(), with.end(), isThing), static_cast<std::ptrdiff_t>(together));
  EXPECT_GE(echoes.getReport().kept_outliers, together);
  EXPECT_LT(with.size(), without.size() + together + 10);
}

TEST(OutlierRemoval, AFailureLeavesNothingBehind)
{
  OutlierRemoval<pcl::PointXYZ> removal(true);
  pcl::PointCloud<pcl::PointXYZ> out;
  removal.setInputCloud(scan());
  removal.filter(out);
  EXPECT_TRUE(removal.getStatus().ok());
  removal.setInputCloud(nullptr);
  removal.filter(out);
  EXPECT_FALSE(removal.getStatus().ok());
  pcl::PointCloud<pcl::PointXYZ>::Ptr few(new pcl::PointCloud<pcl::PointXYZ>);
  few->push_back({1.0f, 2.0f, 3.0f});
  removal.setInputCloud(few);
  removal.setKeepOrganized(true);
  removal.filter(out);
  EXPECT_FALSE(removal.getStatus().ok());
  ASSERT_EQ(out.size(), 1U);
  EXPECT_FALSE(pcl::isFinite(out[0]));
}

TEST(OutlierRemoval, ThreadsChangeNothingAndABadNumberIsRefused)
{
  const auto cloud = scan();
  OutlierRemoval<pcl::PointXYZ> removal;
  const pcl::Indices all = kept(removal, cloud);
  removal.setNumberOfThreads(1);
  EXPECT_EQ(removal.getNumberOfThreads(), 1u);
  EXPECT_EQ(kept(removal, cloud), all);
  removal.setNumberOfThreads(-1);
  EXPECT_TRUE(kept(removal, cloud).empty());
  EXPECT_EQ(removal.getStatus().code(), StatusCode::InvalidArgument) << removal.getStatus().message();
}

TEST(OutlierRemoval, SaysWhyPointsAreNoSurface)
{
  pcl::PointCloud<pcl::PointXYZ>::Ptr few(new pcl::PointCloud<pcl::PointXYZ>);
  for (int i = 0; i < 10; ++i)
    few->push_back({static_cast<float>(i), 0.0f, 0.0f});
  for (const bool negative : {false, true}) {
    OutlierRemoval<pcl::PointXYZ> removal(true);
    removal.setNegative(negative);
    EXPECT_TRUE(kept(removal, few).empty());
    EXPECT_FALSE(removal.getStatus().ok());
    EXPECT_NE(removal.getStatus().message().find("10"), std::string::npos) << removal.getStatus().message();
  }
}

} // namespace outlier_removal_test
