// SPDX-License-Identifier: BSD-3-Clause
// MaterialRemoval and DeviationEstimation on a point type that PCL does not know, with only their own headers; one
// surface for both; the parts of a cloud that are not a surface.
#include <pcl_spiral/verify/deviation_estimation.h>
#include <pcl_spiral/verify/material_removal.h>

#include "support/passes.h"
#include "support/reference.h"

#include <pcl/register_point_struct.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

struct EIGEN_ALIGN16 ScannerPoint {
  PCL_ADD_POINT4D;
  float reflectance = 0.0f;
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};
POINT_CLOUD_REGISTER_POINT_STRUCT(ScannerPoint, (float, x, x)(float, y, y)(float, z, z)(float, reflectance, reflectance))

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

constexpr double R = 10.0, h = 0.05;

struct Scene {
  SurfacePtr surface = quadric(150.0, -150.0, Region({circle({0, 0}, 25.0)}));
  CheckedPath path = straightPasses(*surface, {-20, -18, -16, -14, -12, -10, -8, -6, -4, -2, 0, 2, 4, 6, 8}, 26.0, 2.0);
  Sampled scan = sampleUniform(*surface, 5000, 1);
  pcl::PointCloud<ScannerPoint>::Ptr own{new pcl::PointCloud<ScannerPoint>};
  Scene()
  {
    for (const Eigen::Vector3d& p : scan.points) {
      own->emplace_back();
      own->back().getVector3fMap() = p.cast<float>();
    }
  }
  template <typename Class>
  void give(Class& judge) const
  {
    judge.setInputToolpath(toolpath(path));
    if constexpr (std::is_same_v<Class, MaterialRemoval<ScannerPoint>> || std::is_same_v<Class, MaterialRemoval<pcl::PointXYZ>>) {
      judge.setToolRadius(R);
      judge.setScallopHeight(h);
    }
  }
};

} // namespace

TEST(VerifyClasses, AnOwnPointTypeGivesTheSame)
{
  const Scene scene;
  MaterialRemoval<ScannerPoint> own;
  MaterialRemoval<pcl::PointXYZ> plain;
  scene.give(own);
  scene.give(plain);
  own.setInputCloud(scene.own);
  plain.setInputCloud(toCloud(scene.scan.points));
  pcl::PointCloud<pcl::PointXYZI> a, b;
  own.compute(a);
  plain.compute(b);
  ASSERT_TRUE(own.getStatus().ok());
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    EXPECT_EQ(a[i].intensity, b[i].intensity);
  DeviationEstimation<ScannerPoint> deviation;
  scene.give(deviation);
  deviation.setInputCloud(scene.own);
  deviation.compute(a);
  EXPECT_TRUE(deviation.getStatus().ok());
  EXPECT_LT(deviation.getReport().rms, 1e-3);
}

TEST(VerifyClasses, OneSurfaceServesBoth)
{
  const Scene scene;
  const auto cloud = toCloud(scene.scan.points);
  DeviationEstimation<pcl::PointXYZ> deviation;
  scene.give(deviation);
  deviation.setInputCloud(cloud);
  pcl::PointCloud<pcl::PointXYZI> out, shared;
  deviation.compute(out);
  MaterialRemoval<pcl::PointXYZ> removal;
  scene.give(removal);
  removal.setInputCloud(cloud);
  removal.compute(out);
  removal.setReferenceSurface(deviation.getReferenceSurface());
  removal.compute(shared);
  EXPECT_EQ(removal.getReferenceSurface(), deviation.getReferenceSurface());
  ASSERT_EQ(out.size(), shared.size());
  for (std::size_t i = 0; i < out.size(); ++i)
    EXPECT_EQ(out[i].intensity, shared[i].intensity);
}

TEST(VerifyClasses, WhatIsNoSurfaceIsLeftOutInItsPlace)
{
  const Scene scene;
  const auto cloud = toCloud(scene.scan.points);
  const auto plain = toCloud(scene.scan.points);
  (*cloud)[7].x = std::numeric_limits<float>::quiet_NaN();
  (*cloud)[9] = (*cloud)[8];
  cloud->is_dense = false;
  MaterialRemoval<pcl::PointXYZ> removal;
  scene.give(removal);
  pcl::PointCloud<pcl::PointXYZI> out, few, all;
  removal.setInputCloud(plain);
  removal.compute(all);
  removal.setInputCloud(cloud);
  removal.compute(out);
  ASSERT_EQ(out.size(), cloud->size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (i == 7 || i == 9)
      EXPECT_TRUE(std::isnan(out[i].intensity));
    else
      EXPECT_NEAR(out[i].intensity, all[i].intensity, 1e-3) << i;
  }
  pcl::IndicesPtr indices(new pcl::Indices);
  for (int i = 4999; i >= 0; --i)
    if ((*plain)[i].x > -10.0f)
      indices->push_back(i);
  removal.setInputCloud(plain);
  removal.setIndices(indices);
  removal.compute(few);
  ASSERT_EQ(few.size(), indices->size());
  for (std::size_t k = 0; k < few.size(); ++k)
    if ((*plain)[(*indices)[k]].x > -8.0f) // inside, the fits are the same
      EXPECT_NEAR(few[k].intensity, all[(*indices)[k]].intensity, 1e-3);
}

TEST(VerifyClasses, SettingsOutOfRangeAreNamed)
{
  const Scene scene;
  MaterialRemoval<pcl::PointXYZ> removal;
  removal.setInputCloud(toCloud(scene.scan.points));
  removal.setInputToolpath(toolpath(scene.path));
  pcl::PointCloud<pcl::PointXYZI> out;
  const auto refused = [&](const char* what) {
    removal.compute(out);
    EXPECT_TRUE(out.empty());
    EXPECT_EQ(removal.getStatus().code(), StatusCode::InvalidArgument);
    EXPECT_NE(removal.getStatus().message().find(what), std::string::npos) << removal.getStatus().message();
  };
  refused("tool radius");
  removal.setToolRadius(R);
  refused("scallop height");
  removal.setScallopHeight(R);
  refused("scallop height");
  removal.setScallopHeight(h);
  removal.setChordError(-1.0);
  refused("chord error");
  removal.setChordError(0.0);
  removal.setReach(std::nan(""));
  refused("reach");
  removal.setReach(0.0);
  removal.compute(out);
  EXPECT_TRUE(removal.getStatus().ok());
  int calls = 0;
  removal.setProgressCallback([&](double, const std::string&) { return ++calls < 2; });
  removal.compute(out);
  EXPECT_EQ(removal.getStatus().code(), StatusCode::Cancelled);
  EXPECT_TRUE(out.empty());
}
