// SPDX-License-Identifier: BSD-3-Clause
// Neighbour search against brute force; the spatial order does not depend on the order of the input.
#include "search/neighbour_search.h"

#include <gtest/gtest.h>

#include <random>

namespace neighbour_search_test {

namespace {

std::vector<Eigen::Vector3f>
randomSurface(std::size_t n, std::uint64_t seed)
{
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<float> u(-100.0f, 100.0f);
  std::vector<Eigen::Vector3f> points(n);
  for (auto& p : points) {
    const float x = u(random), y = u(random);
    p = {x + 5000.0f, y, 0.003f * x * y};
  }
  return points;
}

void
expectBruteForce(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3d& query, const pcl_spiral::PointBlocks& blocks,
                 const pcl_spiral::Neighbourhood& found, int k)
{
  std::vector<double> distance;
  for (const auto& p : points)
    distance.push_back((p.cast<double>() - query).norm());
  std::sort(distance.begin(), distance.end());
  ASSERT_EQ(found.size, std::min<int>(k, static_cast<int>(points.size())));
  const double rounding = 1e-4 + 1e-6 * query.norm();
  for (int i = 0; i < found.size; ++i) {
    EXPECT_NEAR(std::sqrt(found.squared_distance[i]), distance[i], rounding);
    const Eigen::Vector3d offset(found.x[i], found.y[i], found.z[i]);
    EXPECT_LT((blocks.position(found.index[i]) - query - offset).norm(), rounding);
  }
}

TEST(NeighbourSearch, PointsOfTheCloudAgainstBruteForce)
{
  for (const int k : {1, 8, 32, 200}) {
    const auto points = randomSurface(3000, 7);
    const pcl_spiral::PointBlocks blocks(points);
    pcl_spiral::NeighbourSearch search(blocks, k);
    for (std::size_t b = 0; b < blocks.blockCount(); b += 7) {
      search.setRun(blocks.blockBox(b));
      for (std::size_t i = blocks.blockBegin(b); i < blocks.blockEnd(b); i += 5) {
        const auto& found = search.find(blocks.position(i));
        expectBruteForce(points, blocks.position(i), blocks, found, k);
        EXPECT_EQ(found.index[0], i);
      }
    }
  }
}

TEST(NeighbourSearch, QueriesOffTheCloudAgainstBruteForce)
{
  const auto points = randomSurface(2000, 8);
  const pcl_spiral::PointBlocks blocks(points);
  pcl_spiral::NeighbourSearch search(blocks, 20);
  for (const Eigen::Vector3d& query : {Eigen::Vector3d(5000, 0, 3), Eigen::Vector3d(5300, 50, -20), Eigen::Vector3d(0, 0, 900)}) {
    pcl_spiral::Box box;
    const Eigen::Vector3f q = query.cast<float>();
    box.extend(q.data());
    search.setRun(box);
    expectBruteForce(points, query, blocks, search.find(query), 20);
  }
}

TEST(NeighbourSearch, PointsOffTheSurfaceDisturbNoOthers)
{
  std::vector<Eigen::Vector3f> points;
  for (const Eigen::Vector3f& p : randomSurface(3000, 11))
    points.emplace_back(p.x() - 5000.0f, p.y(), p.z());
  for (int i = 0; i < 40; ++i)
    points[70 * i].z() += 20.0f + static_cast<float>(i);
  points[1].x() = 1e9f;
  constexpr int k = 17;
  const pcl_spiral::PointBlocks blocks(points);
  pcl_spiral::NeighbourSearch search(blocks, k);
  for (std::size_t b = 0; b < blocks.blockCount(); ++b) {
    search.setRun(blocks.blockBox(b));
    pcl_spiral::NeighbourSearch fresh(blocks, k);
    fresh.setRun(blocks.blockBox(b));
    for (std::size_t i = blocks.blockBegin(b); i < blocks.blockEnd(b); ++i) {
      const auto& found = search.find(blocks.position(i));
      const auto& again = fresh.find(blocks.position(i));
      std::vector<double> distance;
      for (const auto& p : points)
        distance.push_back((p.cast<double>() - blocks.position(i)).norm());
      std::sort(distance.begin(), distance.end());
      ASSERT_EQ(found.size, k);
      for (int j = 0; j < k; ++j) {
        EXPECT_NEAR(std::sqrt(found.squared_distance[j]), distance[j], 1e-4 + 1e-6 * distance[j]) << "point " << i;
        EXPECT_EQ(found.squared_distance[j], again.squared_distance[j]); // independent of earlier queries
        EXPECT_EQ(found.index[j], again.index[j]);
      }
    }
  }
}

TEST(NeighbourSearch, StopsAtTheLargestRadius)
{
  const pcl_spiral::PointBlocks blocks(randomSurface(2000, 8));
  pcl_spiral::NeighbourSearch search(blocks, 20, 10.0f);
  pcl_spiral::Box box;
  const Eigen::Vector3f q(0, 0, 900);
  box.extend(q.data());
  search.setRun(box);
  EXPECT_EQ(search.find(q.cast<double>()).size, 0);
}

TEST(NeighbourSearch, FewerPointsThanAsked)
{
  const auto points = randomSurface(5, 9);
  const pcl_spiral::PointBlocks blocks(points);
  pcl_spiral::NeighbourSearch search(blocks, 32);
  search.setRun(blocks.blockBox(0));
  expectBruteForce(points, blocks.position(2), blocks, search.find(blocks.position(2)), 32);
}

TEST(PointBlocks, OrderDependsOnTheSetAlone)
{
  auto points = randomSurface(50000, 10);
  const pcl_spiral::PointBlocks first(points);
  std::mt19937_64 random(1);
  std::shuffle(points.begin(), points.end(), random);
  const pcl_spiral::PointBlocks second(points);
  for (std::size_t i = 0; i < first.size(); ++i) {
    ASSERT_EQ(first.point(i), second.point(i));
    ASSERT_EQ(points[second.originalIndex(i)], second.point(i));
  }
}

TEST(PointBlocks, BoxHoldsThePointsTightly)
{
  for (const std::size_t n : {5, 100, 1100}) { // blocks do not fill the tree
    const auto points = randomSurface(n, 12);
    pcl_spiral::Box box;
    for (const auto& p : points)
      box.extend(p.data());
    const pcl_spiral::PointBlocks blocks(points);
    EXPECT_EQ(blocks.box().low, box.low);
    EXPECT_EQ(blocks.box().high, box.high);
  }
}

TEST(PointBlocks, NearestAgainstBruteForce)
{
  const auto points = randomSurface(5000, 11);
  const pcl_spiral::PointBlocks blocks(points);
  for (int t = 0; t < 50; ++t) {
    const Eigen::Vector3d query(4900 + 4 * t, -110 + 5 * t, 0.5 * t);
    double best = 1e30;
    for (const auto& p : points)
      best = std::min(best, (p.cast<double>() - query).norm());
    EXPECT_NEAR((blocks.position(blocks.nearest(query)) - query).norm(), best, 1e-3);
  }
}

} // namespace

} // namespace neighbour_search_test
