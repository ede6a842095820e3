// SPDX-License-Identifier: BSD-3-Clause
#include "support/sampling.h"

#include <pcl_spiral/search/elliptic_gabriel_graph.h>

#include <pcl/console/print.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <limits>

namespace elliptic_gabriel_graph_test {

using namespace pcl_spiral;
using Eigen::Vector3d;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;

namespace {

Cloud::Ptr
randomCloud(std::size_t n, double width, double height, double depth, std::uint64_t seed)
{
  test::Random random(seed);
  std::vector<Vector3d> points(n);
  for (Vector3d& p : points)
    p = Vector3d(random.uniform(0, width), random.uniform(0, height), random.uniform(0, depth));
  return test::toCloud(points);
}

NeighbourLists
graphOf(const Cloud::ConstPtr& cloud, double alpha, int k, double max_edge = 0.0, int threads = 0)
{
  EllipticGabrielGraph<pcl::PointXYZ> egg;
  egg.setInputCloud(cloud);
  egg.setAlpha(alpha);
  egg.setKSearch(k);
  egg.setMaxEdgeLength(max_edge);
  egg.setNumberOfThreads(threads);
  NeighbourLists graph;
  egg.compute(graph);
  EXPECT_TRUE(egg.getStatus().ok()) << egg.getStatus().message();
  return graph;
}

/** The ellipsoid by its definition: coordinates along and across the edge. */
bool
insideByDefinition(const Vector3d& x, const Vector3d& p, const Vector3d& q, double alpha)
{
  const double half = 0.5 * (q - p).norm();
  const Vector3d direction = (q - p) / (2 * half), offset = x - 0.5 * (p + q);
  const double along = offset.dot(direction), across2 = offset.squaredNorm() - along * along;
  return along * along / (half * half) + across2 / (alpha * alpha * half * half) < 1.0;
}

std::size_t
differences(const Cloud& cloud, const NeighbourLists& graph, double alpha)
{
  std::size_t count = 0;
  const auto at = [&](std::size_t i) { return Vector3d(cloud[i].getVector3fMap().cast<double>()); };
  for (std::uint32_t i = 0; i < cloud.size(); ++i)
    for (std::uint32_t j = 0; j < i; ++j) {
      bool free = true;
      for (std::size_t x = 0; x < cloud.size() && free; ++x)
        free = x == i || x == j || !insideByDefinition(at(x), at(i), at(j), alpha);
      count += free != graph.contains(i, j) || free != graph.contains(j, i);
    }
  return count;
}

double
meanDegreeInside(const Cloud& cloud, const NeighbourLists& graph, double width, double margin)
{
  double sum = 0.0, n = 0.0;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (std::abs(cloud[i].x - width / 2) < width / 2 - margin && std::abs(cloud[i].y - width / 2) < width / 2 - margin) {
      sum += static_cast<double>(graph[i].size());
      n += 1.0;
    }
  return sum / n;
}

} // namespace

TEST(EllipticGabrielGraph, AgreesWithTheDefinitionOverAllPoints)
{
  for (double alpha : {0.3, 0.5, 0.75, 1.0, 1.4142}) {
    const auto flat = randomCloud(300, 10, 10, 0, 11), solid = randomCloud(200, 10, 10, 10, 12);
    EXPECT_EQ(differences(*flat, graphOf(flat, alpha, 299), alpha), 0u) << alpha;
    EXPECT_EQ(differences(*solid, graphOf(solid, alpha, 199), alpha), 0u) << alpha;
  }
}

TEST(EllipticGabrielGraph, BlockingTestIsTheEllipsoid)
{
  test::Random random(3);
  const auto point = [&] { return Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)); };
  for (int i = 0; i < 20000; ++i) {
    const Vector3d x = point(), p = point(), q = point();
    const double alpha = random.uniform(0.1, 1.41);
    EXPECT_EQ(blocksEdge(x, p, q, alpha), insideByDefinition(x, p, q, alpha));
  }
}

TEST(EllipticGabrielGraph, MeanDegreeIsFourOverAlpha)
{
  const auto cloud = randomCloud(60000, 245, 245, 0, 5); // spacing 1
  EXPECT_NEAR(meanDegreeInside(*cloud, graphOf(cloud, 0.75, 48), 245, 10), 4 / 0.75, 0.03);
  EXPECT_NEAR(meanDegreeInside(*cloud, graphOf(cloud, 0.5, 64), 245, 10), 4 / 0.5, 0.05);
  EXPECT_NEAR(meanDegreeInside(*cloud, graphOf(cloud, 1.0, 64), 245, 10), 4.0, 0.03);
  const double missed =
      1.0 - static_cast<double>(graphOf(cloud, 0.75, 32).edgeCount()) / static_cast<double>(graphOf(cloud, 0.75, 80).edgeCount());
  EXPECT_LT(missed, 0.002);
  EXPECT_GE(missed, 0.0);
}

TEST(EllipticGabrielGraph, SymmetricSortedAndTheSameForAnyThreadCount)
{
  const auto cloud = randomCloud(20000, 100, 100, 0.3, 8);
  const NeighbourLists one = graphOf(cloud, 0.75, 32, 3.5, 1), two = graphOf(cloud, 0.75, 32, 3.5, 2);
  ASSERT_EQ(one.size(), cloud->size());
  for (std::uint32_t i = 0; i < one.size(); ++i) {
    ASSERT_EQ(one[i].size(), two[i].size());
    for (std::size_t k = 0; k < one[i].size(); ++k) {
      EXPECT_EQ(one[i][k], two[i][k]);
      EXPECT_TRUE(one.contains(one[i][k], i));
      EXPECT_TRUE(k == 0 || one[i][k - 1] < one[i][k]);
      EXPECT_NE(one[i][k], i);
    }
  }
}

TEST(EllipticGabrielGraph, MovesWithTheCloud)
{
  const auto cloud = randomCloud(5000, 50, 50, 5, 21);
  const Eigen::Isometry3d motion = test::randomMotion(4, 100.0);
  Cloud::Ptr moved(new Cloud(*cloud));
  for (auto& p : *moved)
    p.getVector3fMap() = (motion * p.getVector3fMap().cast<double>()).cast<float>();
  const NeighbourLists a = graphOf(cloud, 0.75, 32, 3.5), b = graphOf(moved, 0.75, 32, 3.5);
  std::size_t different = 0;
  for (std::uint32_t i = 0; i < a.size(); ++i)
    for (const std::uint32_t j : a[i])
      different += !b.contains(i, j);
  EXPECT_LT(different, 6u) << "of " << a.edgeCount() << ": rounding of moved coordinates decides a few";
}

TEST(EllipticGabrielGraph, DoesNotBridgeHoles)
{
  auto cloud = randomCloud(10000, 50, 50, 0, 31); // spacing 0.5
  Cloud::Ptr holed(new Cloud);
  for (const auto& p : *cloud)
    if (std::hypot(p.x - 25, p.y - 25) > 3)
      holed->push_back(p);
  const auto longest = [&](const NeighbourLists& graph) {
    float length = 0.0f;
    for (std::uint32_t i = 0; i < graph.size(); ++i)
      for (const std::uint32_t j : graph[i])
        length = std::max(length, ((*holed)[i].getVector3fMap() - (*holed)[j].getVector3fMap()).norm());
    return length;
  };
  EXPECT_GT(longest(graphOf(holed, 0.75, 500)), 4.0f) << "without a cap edges cross the hole";
  EXPECT_LT(longest(graphOf(holed, 0.75, 32, 3.5)), 3.5 * 0.5 * 2.0);
}

TEST(EllipticGabrielGraph, NormalsKeepTheSidesOfAThinWallApart)
{
  auto cloud = randomCloud(20000, 100, 100, 0, 41); // two sheets, spacing 1, 0.4 apart
  pcl::PointCloud<pcl::Normal>::Ptr normals(new pcl::PointCloud<pcl::Normal>);
  for (std::size_t i = 0; i < cloud->size(); ++i) {
    (*cloud)[i].z = i % 2 ? 0.4f : 0.0f;
    normals->push_back(pcl::Normal(0, 0, i % 2 ? 1.0f : -1.0f));
  }
  EllipticGabrielGraph<pcl::PointXYZ> egg;
  egg.setInputCloud(cloud);
  egg.setInputNormals(normals);
  egg.setMaxNormalAngle(60.0);
  egg.setMaxEdgeLength(0.0);
  egg.setKSearch(80);
  NeighbourLists graph;
  egg.compute(graph);
  ASSERT_TRUE(egg.getStatus().ok());
  for (std::uint32_t i = 0; i < graph.size(); ++i)
    for (const std::uint32_t j : graph[i])
      EXPECT_EQ(i % 2, j % 2);
  EXPECT_NEAR(meanDegreeInside(*cloud, graph, 100, 10), 4 / 0.75, 0.06) << "each sheet as if alone";
}

TEST(EllipticGabrielGraph, IndicesAndBadPoints)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  auto cloud = randomCloud(100, 10, 10, 0, 51);
  (*cloud)[10].x = nan;
  cloud->is_dense = false;
  (*cloud)[21] = (*cloud)[20]; // a repeated point
  EllipticGabrielGraph<pcl::PointXYZ> egg;
  egg.setInputCloud(cloud);
  NeighbourLists graph;
  egg.compute(graph);
  ASSERT_TRUE(egg.getStatus().ok());
  EXPECT_EQ(graph[10].size(), 0u);
  EXPECT_TRUE(graph.contains(20, 21));
  pcl::IndicesPtr indices(new pcl::Indices);
  for (int i = 0; i < 100; i += 2)
    indices->push_back(i);
  egg.setIndices(indices);
  egg.compute(graph);
  ASSERT_EQ(graph.size(), 100u);
  for (std::uint32_t i = 0; i < 100; ++i) {
    EXPECT_EQ(graph[i].size() > 0, i % 2 == 0 && i != 10) << i;
    for (const std::uint32_t j : graph[i])
      EXPECT_EQ(j % 2, 0u);
  }
}

TEST(EllipticGabrielGraph, EdgesStartNoMoreThreadsThanALimitLeaves)
{
  testing::FLAGS_gtest_death_test_style = "threadsafe"; // in a separate process that has not started threads yet
  const auto alive = [] {
    const std::filesystem::directory_iterator all("/proc/self/task");
    return std::distance(begin(all), end(all));
  };
  const auto join = [&] {
    std::vector<Eigen::Vector3f> points;
    const auto cloud = randomCloud(20000, 1, 1, 1, 1);
    for (const auto& p : *cloud)
      points.push_back(p.getVector3fMap());
    const auto before = alive();
    const ThreadLimit one(1);
    ellipticGabrielEdges(points, {}, GabrielOptions());
    std::exit(alive() == before ? 0 : 1);
  };
  EXPECT_EXIT(join(), testing::ExitedWithCode(0), "");
}

TEST(EllipticGabrielGraph, SaysWhatIsWrong)
{
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  NeighbourLists graph;
  EllipticGabrielGraph<pcl::PointXYZ> egg;
  EXPECT_EQ(egg.getStatus().code(), StatusCode::NotComputed);
  const auto code = [&] {
    egg.compute(graph);
    EXPECT_EQ(graph.size(), 0u);
    return egg.getStatus().code();
  };
  EXPECT_EQ(code(), StatusCode::InvalidInput);
  egg.setInputCloud(Cloud::Ptr(new Cloud));
  EXPECT_EQ(code(), StatusCode::InvalidInput);
  Cloud::Ptr nans(new Cloud(5, 1, pcl::PointXYZ(NAN, 0, 0)));
  egg.setInputCloud(nans);
  EXPECT_EQ(code(), StatusCode::InvalidInput);
  egg.setInputCloud(randomCloud(50, 1, 1, 1, 1));
  for (double bad : {0.0, -1.0, 1.5, static_cast<double>(NAN)}) {
    egg.setAlpha(bad);
    EXPECT_EQ(code(), StatusCode::InvalidArgument);
  }
  egg.setAlpha(0.75);
  egg.setKSearch(0);
  EXPECT_EQ(code(), StatusCode::InvalidArgument);
  egg.setKSearch(32);
  egg.setMaxNormalAngle(60);
  EXPECT_EQ(code(), StatusCode::InvalidInput) << "no normals";
  egg.setMaxNormalAngle(0);
  egg.setNumberOfThreads(-1);
  EXPECT_EQ(code(), StatusCode::InvalidArgument);
  egg.setNumberOfThreads(0);
  pcl::IndicesPtr outside(new pcl::Indices{0, 50});
  egg.setIndices(outside);
  EXPECT_EQ(code(), StatusCode::InvalidInput);
  Cloud::Ptr single(new Cloud(1, 1, pcl::PointXYZ(1, 2, 3)));
  egg.setIndices(pcl::IndicesPtr());
  egg.setInputCloud(single);
  egg.compute(graph);
  EXPECT_TRUE(egg.getStatus().ok());
  EXPECT_EQ(graph[0].size(), 0u);
}

} // namespace elliptic_gabriel_graph_test
