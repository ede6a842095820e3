// SPDX-License-Identifier: BSD-3-Clause
#include "support/sampling.h"

#include <pcl_spiral/features/centroid_boundary_estimation.h>

#include <pcl/console/print.h>
#include <pcl/search/brute_force.h>
#include <pcl/search/octree.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace centroid_boundary_estimation_test {

using namespace pcl_spiral;
using Eigen::Vector2d;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Estimation = CentroidBoundaryEstimation<pcl::PointXYZ, pcl::Normal>;

namespace {

pcl::PointCloud<pcl::Normal>::Ptr
upwards(std::size_t n)
{
  return pcl::PointCloud<pcl::Normal>::Ptr(new pcl::PointCloud<pcl::Normal>(static_cast<std::uint32_t>(n), 1, pcl::Normal(0, 0, 1)));
}

/** Random points on a square, spacing 1. */
Cloud::Ptr
square(double side, std::uint64_t seed)
{
  test::Random random(seed);
  Cloud::Ptr cloud(new Cloud);
  const auto n = static_cast<std::size_t>(side * side);
  for (std::size_t i = 0; i < n; ++i)
    cloud->push_back(pcl::PointXYZ(static_cast<float>(random.uniform(0, side)), static_cast<float>(random.uniform(0, side)), 0.0f));
  return cloud;
}

double
rimDistance(const pcl::PointXYZ& p, double side)
{
  return std::min(std::min<double>(p.x, side - p.x), std::min<double>(p.y, side - p.y));
}

/** Evenly filled sector of the disc of radius 1, from angle 0. */
BoundaryEvidence
sectorEvidence(double angle)
{
  std::vector<Vector2d> offsets;
  std::vector<double> angles;
  const int rings = 400;
  for (int i = 0; i < rings; ++i) {
    const double r = (i + 0.5) / rings;
    const int n = 2 * (i + 1);
    for (int j = 0; j < n; ++j)
      offsets.emplace_back(r * std::cos((j + 0.5) / n * angle), r * std::sin((j + 0.5) / n * angle));
  }
  return boundaryEvidence(offsets, 1.0, angles);
}

struct Marks {
  double recall = 0.0;    ///< share found of the points within half a spacing of the edge
  double inside = 0.0;    ///< share marked beyond 4 spacings from it
  double precision = 0.0; ///< share of the marked points within 2 spacings of the edge
};

Marks
marksOf(const Cloud& cloud, const pcl::PointCloud<pcl::Boundary>& out, double side)
{
  double edge = 0, edge_marked = 0, inner = 0, inner_marked = 0, marked = 0, marked_near = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const double d = rimDistance(cloud[i], side), mark = out[i].boundary_point;
    edge += d < 0.5;
    edge_marked += d < 0.5 ? mark : 0;
    inner += d > 4.0;
    inner_marked += d > 4.0 ? mark : 0;
    marked += mark;
    marked_near += d < 2.0 ? mark : 0;
  }
  return {edge_marked / edge, inner_marked / inner, marked_near / marked};
}

} // namespace

TEST(BoundaryEvidence, SectorsOfADisc)
{
  EXPECT_NEAR(sectorEvidence(M_PI).offset, 4 / (3 * M_PI), 2e-3);
  EXPECT_NEAR(sectorEvidence(M_PI / 2).offset, 4 * std::sqrt(2.0) / (3 * M_PI), 2e-3);
  EXPECT_NEAR(sectorEvidence(1.5 * M_PI).offset, 4 * std::sqrt(2.0) / (9 * M_PI), 2e-3);
  EXPECT_NEAR(sectorEvidence(2 * M_PI).offset, 0.0, 2e-3);
  EXPECT_NEAR(sectorEvidence(M_PI).gap, M_PI, 0.02);
  EXPECT_NEAR(sectorEvidence(1.5 * M_PI).gap, M_PI / 2, 0.02);
}

TEST(BoundaryEvidence, RandomNeighbourhoodsOfThirtyTwo)
{
  test::Random random(17);
  std::vector<double> angles;
  const auto sample = [&](double sector) { // 32 uniform points; the farthest sets the radius
    std::vector<Vector2d> offsets;
    double radius = 0.0;
    for (int i = 0; i < 32; ++i) {
      const double r = std::sqrt(random.uniform()), a = random.uniform(0, sector);
      offsets.emplace_back(r * std::cos(a), r * std::sin(a));
      radius = std::max(radius, r);
    }
    return boundaryEvidence(offsets, radius, angles);
  };
  std::vector<double> inside, edge, gap_inside, gap_edge;
  double mean_inside = 0.0, mean_edge = 0.0;
  for (int i = 0; i < 40000; ++i) {
    const BoundaryEvidence a = sample(2 * M_PI), b = sample(M_PI);
    inside.push_back(a.offset);
    edge.push_back(b.offset);
    gap_inside.push_back(a.gap * 180 / M_PI);
    gap_edge.push_back(b.gap * 180 / M_PI);
    mean_inside += a.offset / 40000;
    mean_edge += b.offset / 40000;
  }
  for (auto* values : {&inside, &edge, &gap_inside, &gap_edge})
    std::sort(values->begin(), values->end());
  EXPECT_NEAR(mean_inside, 0.109, 0.005);
  EXPECT_NEAR(inside[39960], 0.319, 0.015);
  EXPECT_NEAR(mean_edge, 0.425, 0.02); // 0.411 for points a little inside the edge
  EXPECT_GT(edge[400], 0.31) << "the threshold";
  EXPECT_GT(gap_edge[20000], 183.0);
  EXPECT_LT(gap_inside[39980], 121.0);
}

TEST(CentroidBoundaryEstimation, SquareOutline)
{
  const double side = 100.0;
  for (std::uint64_t seed : {1, 2, 3}) {
    const auto cloud = square(side, seed);
    Estimation estimation;
    estimation.setInputCloud(cloud);
    estimation.setInputNormals(upwards(cloud->size()));
    estimation.setKSearch(32);
    pcl::PointCloud<pcl::Boundary> out;
    estimation.compute(out);
    ASSERT_TRUE(estimation.getStatus().ok());
    ASSERT_EQ(out.size(), cloud->size());
    EXPECT_TRUE(out.is_dense);
    const Marks combined = marksOf(*cloud, out, side);
    EXPECT_GT(combined.recall, 0.97);
    EXPECT_LT(combined.inside, 0.004);
    EXPECT_GT(combined.precision, 0.93);
    for (auto criterion : {BoundaryCriterion::Centroid, BoundaryCriterion::LargestGap}) {
      estimation.setCriterion(criterion);
      estimation.compute(out);
      const Marks alone = marksOf(*cloud, out, side);
      EXPECT_GT(alone.recall, 0.85);
      EXPECT_GT(combined.recall, alone.recall);
      EXPECT_LT(alone.inside, 0.006);
    }
  }
}

TEST(CentroidBoundaryEstimation, PublishedCriterionMissesReentrantCorners)
{
  Cloud::Ptr cloud(new Cloud); // an L of jittered points; the corner point itself at (20, 20)
  test::Random random(5);
  for (int i = 0; i <= 40; ++i)
    for (int j = 0; j <= 40; ++j)
      if (i <= 20 || j <= 20) {
        const bool inner = i % 20 && j % 20;
        const double a = inner ? random.uniform(-0.2, 0.2) : 0.0, b = inner ? random.uniform(-0.2, 0.2) : 0.0;
        cloud->push_back(pcl::PointXYZ(static_cast<float>(i + a), static_cast<float>(j + b), 0));
      }
  std::size_t corner = 0;
  for (std::size_t i = 0; i < cloud->size(); ++i)
    if ((*cloud)[i].x == 20.0f && (*cloud)[i].y == 20.0f)
      corner = i;
  Estimation estimation;
  estimation.setInputCloud(cloud);
  estimation.setInputNormals(upwards(cloud->size()));
  estimation.setKSearch(32);
  pcl::PointCloud<pcl::Boundary> out;
  estimation.setCriterion(BoundaryCriterion::Centroid);
  estimation.compute(out);
  EXPECT_EQ(out[corner].boundary_point, 0);
  EXPECT_NEAR(estimation.getOffsets()[corner], 0.20, 0.07);
  EXPECT_LT(estimation.getOffsets()[corner], 0.25);
  EXPECT_GE(estimation.getGaps()[corner], M_PI / 2 - 1e-6);
  estimation.setCriterion(BoundaryCriterion::Combined);
  estimation.setAngleThreshold(static_cast<float>(95.0 * M_PI / 180.0));
  estimation.compute(out);
  EXPECT_EQ(out[corner].boundary_point, 1);
  for (std::size_t i = 0; i < cloud->size(); ++i)
    if (std::min((*cloud)[i].x, (*cloud)[i].y) > 4.0f && std::max((*cloud)[i].x, (*cloud)[i].y) < 16.0f)
      EXPECT_EQ(out[i].boundary_point, 0);
}

TEST(CentroidBoundaryEstimation, ScoreIsThePublishedOne)
{
  const auto cloud = square(30, 4);
  Estimation estimation;
  estimation.setInputCloud(cloud);
  estimation.setInputNormals(upwards(cloud->size()));
  estimation.setKSearch(32);
  estimation.setMu(7.0);
  pcl::PointCloud<pcl::Boundary> out;
  estimation.compute(out);
  ASSERT_EQ(estimation.getScores().size(), cloud->size());
  for (std::size_t i = 0; i < cloud->size(); ++i)
    EXPECT_NEAR(estimation.getScores()[i], std::exp(7.0 * estimation.getOffsets()[i]), 1e-3);
}

TEST(CentroidBoundaryEstimation, AnySearchRadiusIndicesThreads)
{
  const auto cloud = square(60, 6);
  pcl::IndicesPtr indices(new pcl::Indices);
  for (int i = 3; i < static_cast<int>(cloud->size()); i += 2)
    indices->push_back(i);
  std::vector<std::vector<float>> offsets;
  std::vector<pcl::PointCloud<pcl::Boundary>> outputs;
  const auto run = [&](const pcl::search::Search<pcl::PointXYZ>::Ptr& search, int threads, bool radius) {
    Estimation estimation;
    estimation.setInputCloud(cloud);
    estimation.setInputNormals(upwards(cloud->size()));
    estimation.setIndices(indices);
    estimation.setSearchMethod(search);
    estimation.setNumberOfThreads(threads);
    radius ? estimation.setRadiusSearch(3.2) : estimation.setKSearch(32);
    outputs.emplace_back();
    estimation.compute(outputs.back());
    EXPECT_EQ(outputs.back().size(), indices->size());
    offsets.push_back(estimation.getOffsets());
  };
  run(nullptr, 1, false);
  run(nullptr, 2, false);
  run(pcl::search::Search<pcl::PointXYZ>::Ptr(new pcl::search::BruteForce<pcl::PointXYZ>), 2, false);
  run(pcl::search::Search<pcl::PointXYZ>::Ptr(new pcl::search::Octree<pcl::PointXYZ>(1.0)), 2, false);
  EXPECT_EQ(offsets[0], offsets[1]);
  for (std::size_t i = 0; i < indices->size(); ++i)
    for (std::size_t k = 2; k < 4; ++k) {
      EXPECT_NEAR(offsets[k][i], offsets[0][i], 1e-5);
      EXPECT_EQ(outputs[k][i].boundary_point, outputs[0][i].boundary_point);
    }
  run(nullptr, 2, true);
  double agree = 0.0;
  for (std::size_t i = 0; i < indices->size(); ++i)
    agree += outputs[4][i].boundary_point == outputs[0][i].boundary_point;
  EXPECT_GT(agree / static_cast<double>(indices->size()), 0.95);
}

TEST(CentroidBoundaryEstimation, BadPointsDoNotAbort)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (bool dense_flag : {false, true}) {
    const auto cloud = square(30, 8);
    const auto normals = upwards(cloud->size());
    (*cloud)[5].x = nan;
    (*cloud)[6].z = std::numeric_limits<float>::infinity();
    (*normals)[7].normal_x = nan;
    (*normals)[8] = pcl::Normal(0, 0, 0);
    cloud->is_dense = dense_flag; // a wrong flag must not matter
    Estimation estimation;
    estimation.setInputCloud(cloud);
    estimation.setInputNormals(normals);
    estimation.setKSearch(32);
    pcl::PointCloud<pcl::Boundary> out;
    estimation.compute(out);
    ASSERT_TRUE(estimation.getStatus().ok());
    EXPECT_FALSE(out.is_dense);
    for (std::size_t i = 0; i < cloud->size(); ++i)
      EXPECT_EQ(std::isnan(estimation.getScores()[i]), i >= 5 && i <= 8) << i;
  }
}

TEST(CentroidBoundaryEstimation, PointsChangedInPlace)
{
  const auto cloud = square(40, 9);
  Estimation estimation;
  estimation.setInputCloud(cloud);
  estimation.setInputNormals(upwards(cloud->size()));
  estimation.setKSearch(32);
  pcl::PointCloud<pcl::Boundary> out;
  estimation.compute(out);
  *cloud = *square(40, 10);
  estimation.resetSearch();
  estimation.compute(out);
  Estimation fresh;
  fresh.setInputCloud(cloud);
  fresh.setInputNormals(upwards(cloud->size()));
  fresh.setKSearch(32);
  pcl::PointCloud<pcl::Boundary> expected;
  fresh.compute(expected);
  EXPECT_EQ(estimation.getOffsets(), fresh.getOffsets());
}

TEST(CentroidBoundaryEstimation, SaysWhatIsWrong)
{
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  const auto cloud = square(20, 12);
  const auto codeOf = [&](auto change) {
    Estimation estimation;
    estimation.setInputCloud(cloud);
    estimation.setInputNormals(upwards(cloud->size()));
    estimation.setKSearch(32);
    change(estimation);
    pcl::PointCloud<pcl::Boundary> out(3, 1);
    estimation.compute(out);
    EXPECT_TRUE(out.empty());
    EXPECT_TRUE(estimation.getScores().empty());
    return estimation.getStatus().code();
  };
  const auto input = StatusCode::InvalidInput, argument = StatusCode::InvalidArgument;
  EXPECT_EQ(codeOf([](Estimation& e) { e.setInputCloud(nullptr); }), input);
  EXPECT_EQ(codeOf([](Estimation& e) { e.setInputCloud(Cloud::Ptr(new Cloud)); }), input);
  EXPECT_EQ(codeOf([](Estimation& e) { e.setInputNormals(nullptr); }), input);
  EXPECT_EQ(codeOf([](Estimation& e) { e.setInputNormals(upwards(3)); }), input);
  EXPECT_EQ(codeOf([](Estimation& e) { e.setSearchSurface(square(20, 13)); }), input);
  EXPECT_EQ(codeOf([](Estimation& e) { e.setIndices(pcl::IndicesPtr(new pcl::Indices{400})); }), input);
  EXPECT_EQ(codeOf([](Estimation& e) { e.setInputCloud(Cloud::Ptr(new Cloud(400, 1, pcl::PointXYZ(NAN, NAN, NAN)))); }), input);
  EXPECT_EQ(codeOf([](Estimation& e) { e.setRadiusSearch(2.0); }), argument);
  EXPECT_EQ(codeOf([](Estimation& e) { e.setKSearch(0); }), argument);
  EXPECT_EQ(codeOf([](Estimation& e) { e.setKSearch(-3); }), argument);
  EXPECT_EQ(codeOf([](Estimation& e) {
              e.setKSearch(0);
              e.setRadiusSearch(NAN);
            }),
            argument);
  EXPECT_EQ(codeOf([](Estimation& e) { e.setOffsetThreshold(0.0); }), argument);
  EXPECT_EQ(codeOf([](Estimation& e) { e.setNumberOfThreads(-1); }), argument);
  Estimation same;
  same.setInputCloud(cloud);
  same.setSearchSurface(cloud); // the input itself does not count as another surface
  same.setInputNormals(upwards(cloud->size()));
  same.setKSearch(500); // more than the cloud has
  pcl::PointCloud<pcl::Boundary> out;
  same.compute(out);
  EXPECT_TRUE(same.getStatus().ok());
}

} // namespace centroid_boundary_estimation_test
