// SPDX-License-Identifier: BSD-3-Clause
#include "support/sampling.h"

#include <pcl_spiral/search/impl/point_selection.h>
#include <pcl_spiral/surface/surface_preparation.h>

#include <pcl/console/print.h>
#include <pcl/filters/statistical_outlier_removal.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace surface_preparation_test {

using namespace pcl_spiral;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Normals = pcl::PointCloud<pcl::Normal>;

namespace {

const float nan_value = std::numeric_limits<float>::quiet_NaN();

Cloud::Ptr
dome(std::size_t n, std::uint64_t seed)
{
  return test::toCloud(test::sampleUniform(*test::spheroidCap(80.0, 45.0), n, seed).points);
}

std::vector<Eigen::Vector3f>
positions(const Cloud& cloud)
{
  std::vector<Eigen::Vector3f> points;
  for (const auto& p : cloud)
    points.push_back(p.getVector3fMap());
  return points;
}

} // namespace

TEST(PointSelection, DistinctKeepsTheFirstOfEachPlace)
{
  auto points = positions(*dome(2000, 1));
  test::Random random(2);
  for (int i = 0; i < 500; ++i)
    points.push_back(points[random.below(2000)]);
  points.emplace_back(0.0f, 1.0f, 2.0f);
  points.emplace_back(-0.0f, 1.0f, 2.0f); // the same place
  std::vector<std::uint32_t> expected;
  std::set<std::tuple<float, float, float>> seen;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (seen.insert({points[i].x(), points[i].y(), points[i].z()}).second)
      expected.push_back(static_cast<std::uint32_t>(i));
  EXPECT_EQ(distinctPoints(points), expected);
  EXPECT_EQ(expected.size(), 2001u);
}

TEST(PointSelection, OutliersAreThoseOfPcl)
{
  auto cloud = dome(5000, 3);
  test::Random random(4);
  for (int i = 0; i < 30; ++i)
    cloud->push_back(pcl::PointXYZ(static_cast<float>(random.uniform(-90, 90)), static_cast<float>(random.uniform(-90, 90)),
                                   static_cast<float>(random.uniform(60, 120))));
  for (int k : {8, 20}) {
    pcl::StatisticalOutlierRemoval<pcl::PointXYZ> filter;
    filter.setInputCloud(cloud);
    filter.setMeanK(k);
    filter.setStddevMulThresh(3.0);
    pcl::Indices expected;
    filter.filter(expected);
    const auto kept = statisticalInliers(positions(*cloud), k, 3.0);
    EXPECT_EQ(pcl::Indices(kept.begin(), kept.end()), expected);
    EXPECT_LT(kept.size(), cloud->size() - 20);
  }
}

TEST(PointSelection, OnePointAVoxelNearestToItsCentroid)
{
  const auto points = positions(*dome(20000, 5));
  const double edge = 4.0;
  std::map<std::array<int, 3>, std::vector<std::uint32_t>> voxels;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d cell = (points[i].cast<double>() / edge).array().floor();
    voxels[{int(cell.x()), int(cell.y()), int(cell.z())}].push_back(static_cast<std::uint32_t>(i));
  }
  const auto kept = voxelRepresentatives(points, edge);
  ASSERT_EQ(kept.size(), voxels.size());
  const std::set<std::uint32_t> set(kept.begin(), kept.end());
  for (const auto& [cell, members] : voxels) {
    Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
    for (auto i : members)
      centroid += points[i].cast<double>() / static_cast<double>(members.size());
    double nearest = 1e9, chosen = 1e9;
    for (auto i : members) {
      const double d = (points[i].cast<double>() - centroid).norm();
      nearest = std::min(nearest, d);
      if (set.count(i))
        chosen = d;
    }
    EXPECT_NEAR(chosen, nearest, 1e-9);
  }
  EXPECT_TRUE(voxelRepresentatives(points, 1e-7).empty()) << "more voxels than fit";
}

TEST(SurfacePreparation, CountsEveryPointAndKeepsItsIndex)
{
  auto cloud = dome(6000, 6);
  cloud->push_back(pcl::PointXYZ(nan_value, 0, 0));
  cloud->push_back(pcl::PointXYZ(0, std::numeric_limits<float>::infinity(), 0));
  for (int i = 0; i < 40; ++i)
    cloud->push_back((*cloud)[static_cast<std::size_t>(i) * 7]);
  cloud->push_back(pcl::PointXYZ(0, 0, 300)); // an outlier
  cloud->is_dense = false;
  const Cloud before = *cloud;
  SurfacePreparation<pcl::PointXYZ> preparation;
  preparation.setInputCloud(cloud);
  preparation.setOutlierRemoval(16, 6.0);
  preparation.setThinning(1.0);
  Cloud out;
  Normals normals;
  preparation.compute(out, normals);
  ASSERT_TRUE(preparation.getStatus().ok()) << preparation.getStatus().message();
  const SurfaceReport& counts = preparation.getReport();
  EXPECT_EQ(counts.input, 6043u);
  EXPECT_EQ(counts.nonfinite, 2u);
  EXPECT_EQ(counts.duplicate, 40u);
  EXPECT_EQ(counts.outlier, 1u);
  EXPECT_GT(counts.thinned, 0u);
  EXPECT_EQ(counts.nonfinite + counts.duplicate + counts.outlier + counts.thinned + counts.surplus + counts.isolated + counts.clustered +
                counts.other_part + counts.used,
            counts.input);
  ASSERT_EQ(out.size(), counts.used);
  ASSERT_EQ(normals.size(), counts.used);
  ASSERT_EQ(preparation.getSourceIndices().size(), counts.used);
  EXPECT_TRUE(out.is_dense);
  std::set<std::uint32_t> sources;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const std::uint32_t source = preparation.getSourceIndices()[i];
    EXPECT_EQ(out[i].getVector3fMap(), before[source].getVector3fMap());
    EXPECT_TRUE(sources.insert(source).second);
  }
  EXPECT_EQ(cloud->size(), before.size()) << "the input is not changed";
}

TEST(SurfacePreparation, NormalsAreThoseOfTheSurface)
{
  const auto surface = test::spheroidCap(80.0, 45.0);
  const auto sampled = test::sampleUniform(*surface, 20000, 7);
  SurfacePreparation<pcl::PointXYZ> preparation;
  preparation.setInputCloud(test::toCloud(sampled.points));
  Cloud out;
  Normals normals;
  const auto worstCosine = [&](double sign) {
    preparation.compute(out, normals);
    double worst = 1.0;
    for (std::size_t i = 0; i < out.size(); ++i) {
      const Eigen::Vector3d exact = sampled.normals[preparation.getSourceIndices()[i]];
      worst = std::min(worst, sign * exact.dot(normals[i].getNormalVector3fMap().cast<double>()));
      EXPECT_NEAR(normals[i].getNormalVector3fMap().norm(), 1.0, 1e-5);
    }
    return worst;
  };
  EXPECT_GT(worstCosine(1.0), std::cos(8.0 * M_PI / 180.0));
  preparation.setFlipNormals(true);
  EXPECT_GT(worstCosine(-1.0), std::cos(8.0 * M_PI / 180.0));
  preparation.setFlipNormals(false);
  preparation.setViewPoint(Eigen::Vector3d(0, 0, -500)); // the scanner was inside
  EXPECT_GT(worstCosine(-1.0), std::cos(8.0 * M_PI / 180.0));
  EXPECT_EQ(preparation.getSurface()->size(), out.size());
}

TEST(SurfacePreparation, SpatialOrderWhateverTheInputOrder)
{
  const auto cloud = dome(5000, 8);
  Cloud::Ptr other(new Cloud);
  for (const std::size_t i : test::shuffled(cloud->size(), 9))
    other->push_back((*cloud)[i]);
  SurfacePreparation<pcl::PointXYZ> preparation;
  Cloud a, b;
  Normals normals;
  preparation.setInputCloud(cloud);
  preparation.compute(a, normals);
  preparation.setInputCloud(other);
  preparation.compute(b, normals);
  double step = 0.0, given = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].getVector3fMap(), b[i].getVector3fMap());
    if (i == 0)
      continue;
    step += (a[i].getVector3fMap() - a[i - 1].getVector3fMap()).norm();
    given += ((*cloud)[i].getVector3fMap() - (*cloud)[i - 1].getVector3fMap()).norm();
  }
  EXPECT_LT(step, 0.1 * given) << "neighbours in the order are neighbours in space";
}

TEST(SurfacePreparation, IndicesChoose)
{
  const auto cloud = dome(4000, 10);
  pcl::IndicesPtr indices(new pcl::Indices);
  for (int i = 0; i < 4000; i += 2)
    indices->push_back(i);
  SurfacePreparation<pcl::PointXYZ> preparation;
  preparation.setInputCloud(cloud);
  preparation.setIndices(indices);
  Cloud out;
  Normals normals;
  preparation.compute(out, normals);
  EXPECT_EQ(out.size(), 2000u);
  for (const std::uint32_t i : preparation.getSourceIndices())
    EXPECT_EQ(i % 2, 0u);
}

TEST(SurfacePreparation, SaysWhatIsWrong)
{
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  const auto codeOf = [](const Cloud::Ptr& cloud, auto change) {
    SurfacePreparation<pcl::PointXYZ> preparation;
    preparation.setInputCloud(cloud);
    change(preparation);
    Cloud out(3, 1);
    Normals normals(3, 1);
    preparation.compute(out, normals);
    EXPECT_TRUE(out.empty() && normals.empty() && preparation.getSourceIndices().empty());
    EXPECT_GT(preparation.getStatus().message().size(), 20u);
    return preparation.getStatus().code();
  };
  using Preparation = SurfacePreparation<pcl::PointXYZ>;
  const auto none = [](Preparation&) {};
  const auto input = StatusCode::InvalidInput, argument = StatusCode::InvalidArgument;
  EXPECT_EQ(codeOf(nullptr, none), input);
  EXPECT_EQ(codeOf(Cloud::Ptr(new Cloud), none), input);
  EXPECT_EQ(codeOf(Cloud::Ptr(new Cloud(100, 1, pcl::PointXYZ(nan_value, 0, 0))), none), input);
  EXPECT_EQ(codeOf(Cloud::Ptr(new Cloud(100, 1, pcl::PointXYZ(1, 2, 3))), none), input) << "one place";
  EXPECT_EQ(codeOf(dome(49, 1), none), input);
  const auto cloud = dome(500, 2);
  EXPECT_EQ(codeOf(cloud, [](Preparation& p) { p.setThinning(100.0); }), input) << "nothing left";
  EXPECT_EQ(codeOf(cloud, [](Preparation& p) { p.setThinning(-1.0); }), argument);
  EXPECT_EQ(codeOf(cloud, [](Preparation& p) { p.setThinning(1e-6); }), argument);
  EXPECT_EQ(codeOf(cloud, [](Preparation& p) { p.setOutlierRemoval(-1); }), argument);
  EXPECT_EQ(codeOf(cloud, [](Preparation& p) { p.setOutlierRemoval(8, 0.0); }), argument);
  EXPECT_EQ(codeOf(cloud, [](Preparation& p) { p.setKSearch(2); }), argument);
  EXPECT_EQ(codeOf(cloud, [](Preparation& p) { p.setIndices(pcl::IndicesPtr(new pcl::Indices{500})); }), input);
}

} // namespace surface_preparation_test
