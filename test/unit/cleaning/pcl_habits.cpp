// SPDX-License-Identifier: BSD-3-Clause
// What users of PCL expect: the sensor of a cloud, indices as queries, other fields kept, pcl::Indices, and no old result.
#include <pcl_spiral/cleaning/outlier_removal.h>
#include <pcl_spiral/cleaning/part_region.h>
#include <pcl_spiral/features/boundary_loops.h>
#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>
#include <pcl_spiral/surface/mls_projector.h>
#include <pcl_spiral/surface/surface_preparation.h>

#include "support/scratch_folder.h"

#include <pcl/features/normal_3d.h>
#include <pcl/filters/extract_indices.h>
#include <pcl/io/pcd_io.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <type_traits>

namespace pcl_habits_test {

namespace {

using namespace pcl_spiral;
using P = pcl::PointXYZ;
using Cloud = pcl::PointCloud<P>;
using Normals = pcl::PointCloud<pcl::Normal>;

static_assert(std::is_same_v<decltype(BoundaryLoop::indices), pcl::Indices>);
static_assert(std::is_same_v<decltype(LeftOutPoints::indices), pcl::Indices>);
static_assert(std::is_same_v<decltype(StandingCluster::indices), pcl::Indices>);
static_assert(std::is_same_v<std::decay_t<decltype(std::declval<SurfacePreparation<P>>().getSourceIndices())>, pcl::Indices>);

constexpr double ball = 100.0; // radius of the sphere, mm

/** A cap of a sphere about (off, off, 0), 80 mm across. */
Cloud::Ptr
cap(double off = 0.0, double noise = 0.0)
{
  const Cloud::Ptr cloud(new Cloud);
  std::mt19937 random(6);
  std::uniform_real_distribution<double> any(-40.0, 40.0);
  std::normal_distribution<double> normal(0.0, 1.0);
  while (cloud->size() < 6000) {
    const double x = any(random), y = any(random);
    if (std::hypot(x, y) < 40.0)
      cloud->emplace_back(static_cast<float>(x + off), static_cast<float>(y + off),
                          static_cast<float>(std::sqrt(ball * ball - x * x - y * y) + noise * normal(random)));
  }
  return cloud;
}

/** Mean z of the normals of the surface that \p scanned makes. */
double
side(ScannedSurface<P>& scanned, std::string* warnings = nullptr)
{
  Surface::ConstPtr surface;
  scanned.compute(surface);
  EXPECT_TRUE(surface) << scanned.getStatus().message();
  double sum = 0.0;
  for (std::size_t i = 0; surface && i < surface->size(); ++i)
    sum += surface->normal(i).z() / static_cast<double>(surface->size());
  if (warnings)
    for (const pcl_spiral::Diagnostic& warning : surface->warnings())
      *warnings += warning.text() + "\n";
  return sum;
}

bool
has(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

} // namespace

TEST(PclHabits, TheSensorOfACloudIsAViewPoint)
{
  const Cloud::Ptr below = cap();
  below->sensor_origin_ = Eigen::Vector4f(0.0f, 0.0f, -500.0f, 0.0f);
  ScannedSurface<P> scanned;
  scanned.setInputCloud(below);
  std::string warnings;
  EXPECT_LT(side(scanned, &warnings), -0.9);
  EXPECT_TRUE(has(warnings, "sensor_origin_")) << "it may be stale: pcl::transformPointCloud leaves it";
  scanned.setViewPoint({0.0, 0.0, -500.0});
  warnings.clear();
  EXPECT_LT(side(scanned, &warnings), -0.9);
  EXPECT_EQ(warnings, "") << "the user gave it";
  scanned.setViewPoint({0.0, 0.0, 500.0});
  EXPECT_GT(side(scanned), 0.9) << "what the user sets counts first";
  scanned.clearViewPoint();
  EXPECT_LT(side(scanned), -0.9);
  const ScratchFolder folder;
  const std::string file = folder.path("below.pcd");
  ASSERT_EQ(pcl::io::savePCDFileBinary(file, *below), 0);
  scanned.setInputCloud(readCloud(file).cloud);
  EXPECT_LT(side(scanned), -0.9) << "by the reader of the project";
  below->sensor_origin_.setZero();
  scanned.setInputCloud(below);
  EXPECT_GT(side(scanned), 0.9) << "zero is no place";
}

TEST(PclHabits, NormalsThatSayNothingAreRefusedOrNamed)
{
  const Cloud::Ptr scan = cap();
  for (const float value : {std::numeric_limits<float>::quiet_NaN(), 0.0f}) {
    const auto normals = pcl::make_shared<Normals>(scan->size(), 1, pcl::Normal(value, value, value));
    ScannedSurface<P> scanned;
    scanned.setInputCloud(scan);
    scanned.setInputNormals(normals);
    Surface::ConstPtr surface;
    scanned.compute(surface);
    EXPECT_EQ(scanned.getStatus().code(), StatusCode::InvalidInput);
    EXPECT_TRUE(has(scanned.getStatus().message(), "6000") && has(scanned.getStatus().message(), "setInputNormals"));
    scanned.setInputNormals(nullptr); // the remedy
    EXPECT_GT(side(scanned), 0.9);
    scanned.setInputNormals(normals);
    scanned.setTrustNormals(false);
    std::string warnings;
    EXPECT_GT(side(scanned, &warnings), 0.9);
    EXPECT_TRUE(has(warnings, "not used")) << warnings;
  }
}

TEST(PclHabits, NormalsTowardsTheDefaultViewPointAreWarnedOf)
{
  const Cloud::Ptr scan = cap();
  pcl::NormalEstimation<P, pcl::Normal> estimation;
  estimation.setInputCloud(scan);
  estimation.setKSearch(20);
  const auto normals = pcl::make_shared<Normals>();
  estimation.compute(*normals);
  ScannedSurface<P> scanned;
  scanned.setInputCloud(scan);
  scanned.setInputNormals(normals);
  std::string warnings;
  EXPECT_LT(side(scanned, &warnings), -0.9);
  EXPECT_TRUE(has(warnings, "face away from +z") && has(warnings, "the hollow side")) << warnings;
  for (const bool confirmed : {false, true}) { // both remedies
    scanned.setFlipNormals(!confirmed);
    if (confirmed)
      scanned.setViewPoint({0.0, 0.0, -10.0});
    std::string none;
    EXPECT_GT((confirmed ? -1.0 : 1.0) * side(scanned, &none), 0.9);
    EXPECT_EQ(none, "");
  }
}

TEST(PclHabits, WhatSinglePrecisionTakesIsNamed)
{
  for (const double off : {0.0, 4000.0, 440000.0}) {
    SpiralToolpathGenerator<P> spiral;
    spiral.setInputCloud(cap(off));
    spiral.setToolRadius(5.0);
    spiral.setScallopHeight(0.1);
    pcl::PointCloud<ToolpathPoint> path;
    spiral.compute(path);
    ASSERT_TRUE(spiral.getStatus().ok()) << spiral.getStatus().message();
    double farthest = 0.0, stated = 0.0;
    for (const ToolpathPoint& p : path)
      farthest = std::max(farthest, std::abs((p.getVector3fMap().cast<double>() - Eigen::Vector3d(off, off, 0.0)).norm() - ball));
    for (const pcl_spiral::Diagnostic& warning : spiral.getReport().warnings)
      if (const std::size_t at = warning.text().find("by up to "); at != std::string::npos && has(warning.text(), "single precision"))
        stated = std::stod(warning.text().substr(at + 9));
    EXPECT_LT(farthest, spiral.getChordError() + 2.0 * stated) << off; // of the scan, then of the path
    if (off < 1e5)
      EXPECT_EQ(stated, 0.0) << off;
    else
      EXPECT_LT(stated, 2.0 * farthest) << off;
  }
}

TEST(PclHabits, IndicesAreQueriesThatAllPointsSupport)
{
  const Cloud::Ptr scan = cap(0.0, 0.05);
  MLSProjector<P, pcl::PointNormal> projector;
  projector.setInputCloud(scan);
  projector.setSearchRadius(6.0);
  pcl::PointCloud<pcl::PointNormal> all, some;
  projector.compute(all);
  ASSERT_EQ(all.size(), scan->size());
  const pcl::IndicesPtr indices(new pcl::Indices{5000, 7, 311});
  pcl::CloudSurfaceProcessing<P, pcl::PointNormal>& processing = projector;
  processing.setIndices(indices);
  processing.process(some);
  ASSERT_EQ(some.size(), 3u) << projector.getStatus().message();
  for (std::size_t i = 0; i < some.size(); ++i) {
    const pcl::PointNormal &a = some[i], &b = all[static_cast<std::size_t>((*indices)[i])];
    EXPECT_TRUE(a.getVector3fMap() == b.getVector3fMap() && a.getNormalVector3fMap() == b.getNormalVector3fMap());
  }
}

TEST(PclHabits, OtherFieldsOfAQueryAreKept)
{
  const Cloud::Ptr scan = cap();
  const pcl::PointCloud<pcl::PointXYZRGB>::Ptr coloured(new pcl::PointCloud<pcl::PointXYZRGB>);
  for (std::size_t i = 0; i < scan->size(); ++i) {
    pcl::PointXYZRGB p(static_cast<std::uint8_t>(i % 251), static_cast<std::uint8_t>(i / 251), 3);
    p.getVector3fMap() = (*scan)[i].getVector3fMap();
    coloured->push_back(p);
  }
  coloured->header.frame_id = "cell";
  coloured->sensor_origin_ = Eigen::Vector4f(1.0f, 2.0f, 300.0f, 0.0f);
  MLSProjector<pcl::PointXYZRGB, pcl::PointXYZRGBNormal> projector;
  projector.setInputCloud(coloured);
  projector.setIndices(pcl::make_shared<pcl::Indices>(pcl::Indices{700, 20}));
  pcl::PointCloud<pcl::PointXYZRGBNormal> feet;
  projector.compute(feet);
  ASSERT_EQ(feet.size(), 2u);
  EXPECT_TRUE(feet[0].r == 700 % 251 && feet[0].g == 700 / 251 && feet[0].b == 3);
  EXPECT_TRUE(feet[1].r == 20 && feet[1].g == 0);
  EXPECT_GT(feet[0].normal_z, 0.8f);
  EXPECT_EQ(feet.header.frame_id, "cell");
  EXPECT_EQ(feet.sensor_origin_, coloured->sensor_origin_);
}

TEST(PclHabits, IndicesGoStraightIntoExtractIndices)
{
  const Cloud::Ptr scan = cap();
  BoundaryLoops<P> boundaries;
  boundaries.setInputCloud(scan);
  std::vector<BoundaryLoop> loops;
  boundaries.compute(loops);
  ASSERT_FALSE(loops.empty());
  pcl::ExtractIndices<P> extract;
  extract.setInputCloud(scan);
  extract.setIndices(pcl::make_shared<pcl::Indices>(loops.front().indices));
  Cloud rim;
  extract.filter(rim);
  ASSERT_EQ(rim.size(), loops.front().points.size());
  for (std::size_t i = 0; i < rim.size(); ++i)
    EXPECT_EQ(rim[i].getVector3fMap(), loops.front().points[i].cast<float>());
}

TEST(PclHabits, ANullCloudLeavesNeitherOutputNorStatus)
{
  const auto check = [](auto& filter) {
    Cloud output;
    pcl::Indices indices;
    filter.setInputCloud(cap());
    filter.filter(output);
    filter.filter(indices);
    EXPECT_TRUE(filter.getStatus().ok() && !output.empty() && !indices.empty()) << filter.getStatus().message();
    filter.setInputCloud(nullptr);
    EXPECT_EQ(filter.getStatus().code(), StatusCode::InvalidInput);
    filter.filter(output);
    filter.filter(indices);
    EXPECT_TRUE(output.empty() && indices.empty());
    EXPECT_EQ(filter.getStatus().code(), StatusCode::InvalidInput);
  };
  PartRegion<P> region;
  region.setCropBox({Eigen::Vector3d(-20.0, -20.0, 0.0), Eigen::Vector3d(20.0, 20.0, 200.0)});
  check(region);
  OutlierRemoval<P> outliers;
  check(outliers);
}

} // namespace pcl_habits_test
