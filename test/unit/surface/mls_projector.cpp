// SPDX-License-Identifier: BSD-3-Clause
// The projector against exact surfaces, with PCL's point types and a user's own.
#include "support/sampling.h"
#include "support/surfaces.h"

#include <pcl_spiral/surface/mls_projector.h>

#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <algorithm>

/** A user's point type for feet with curvatures. */
struct CurvedPoint {
  PCL_ADD_POINT4D;
  PCL_ADD_NORMAL4D;
  float principal_curvature_x, principal_curvature_y, principal_curvature_z, pc1, pc2;
};
POINT_CLOUD_REGISTER_POINT_STRUCT(
    CurvedPoint, (float, x, x)(float, y, y)(float, z, z)(float, normal_x, normal_x)(float, normal_y, normal_y)(float, normal_z, normal_z)(
                     float, principal_curvature_x, principal_curvature_x)(float, principal_curvature_y, principal_curvature_y)(
                     float, principal_curvature_z, principal_curvature_z)(float, pc1, pc1)(float, pc2, pc2))

namespace {

using namespace pcl_spiral;
using Eigen::Vector3d;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Projector = MLSProjector<pcl::PointXYZ, pcl::PointNormal>;

const test::Region square({test::rectangle(120.0, 100.0)}), middle({test::rectangle(80.0, 70.0)});

TEST(MLSProjector, CurvaturesOfKnownSurfaces)
{
  const std::pair<test::SurfacePtr, test::SurfacePtr> cases[] = {
      {test::ball(150.0, square), test::ball(150.0, middle)},
      {test::cylinder(150.0, square), test::cylinder(150.0, middle)},
      {test::quadric(200.0, -120.0, square), test::quadric(200.0, -120.0, middle)}};
  for (const auto& [surface, inner] : cases) {
    auto queries = test::sampleUniform(*inner, 2000, 7);
    for (std::size_t i = 0; i < queries.points.size(); ++i)
      queries.points[i] += (i % 2 ? 0.3 : -0.3) * queries.normals[i];
    MLSProjector<pcl::PointXYZ, CurvedPoint> projector;
    projector.setInputCloud(test::toCloud(test::sampleUniform(*surface, 30000, 6).points));
    projector.setQueryCloud(test::toCloud(queries.points));
    pcl::PointCloud<CurvedPoint> out;
    projector.compute(out);
    ASSERT_TRUE(projector.getStatus().ok()) << projector.getStatus().message();
    EXPECT_LT(projector.getNoise(), 1e-3);
    std::vector<double> k1, k2;
    projector.getPrincipalCurvatures(k1, k2);
    ASSERT_EQ(out.size(), queries.points.size());
    for (std::size_t i = 0; i < out.size(); ++i) {
      ASSERT_TRUE(projector.getValid()[i]);
      const Vector3d foot = out[i].getVector3fMap().cast<double>();
      const Vector3d exact = surface->closest(queries.points[i]);
      EXPECT_LT((foot - exact).norm(), 5e-4);
      EXPECT_LT((out[i].getNormalVector3fMap().cast<double>() - surface->normal(exact)).norm(), 2e-3);
      const auto [smaller, larger] = surface->principalCurvatures(exact);
      EXPECT_NEAR(k1[i], larger, 4e-4);
      EXPECT_NEAR(k2[i], smaller, 4e-4);
      EXPECT_EQ(out[i].pc1, float(k1[i]));
      EXPECT_EQ(out[i].pc2, float(k2[i]));
      if (larger - smaller > 4e-3) {
        const Vector3d d(out[i].principal_curvature_x, out[i].principal_curvature_y, out[i].principal_curvature_z);
        EXPECT_NEAR(surface->normalCurvature(exact, d), larger, 4e-4);
      }
    }
  }
}

TEST(MLSProjector, MovesWithTheCloudAndForgetsItsOrder)
{
  const auto surface = test::quadric(200.0, -120.0, square);
  const auto points = test::sampleUniform(*surface, 8000, 8).points;
  const auto order = test::shuffled(points.size(), 9);
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity(); // about +z, so that the outside does not change
  motion.rotate(Eigen::AngleAxisd(1.1, Vector3d(0.1, -0.2, 1.0).normalized())).pretranslate(Vector3d(30, -50, 20));
  std::vector<Vector3d> moved(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    moved[i] = motion * points[order[i]];
  Projector projector;
  pcl::PointCloud<pcl::PointNormal> first, second;
  projector.setInputCloud(test::toCloud(points));
  projector.compute(first);
  const auto valid = projector.getValid();
  projector.setInputCloud(test::toCloud(moved));
  projector.compute(second);
  ASSERT_EQ(second.size(), points.size());
  std::size_t feet = 0;
  for (std::size_t i = 0; i < second.size(); ++i) {
    ASSERT_EQ(projector.getValid()[i], valid[order[i]]);
    if (!valid[order[i]])
      continue;
    ++feet;
    const Vector3d expected = motion * first[order[i]].getVector3fMap().cast<double>();
    EXPECT_LT((second[i].getVector3fMap().cast<double>() - expected).norm(), 1e-4);
    EXPECT_NEAR(second[i].curvature, first[order[i]].curvature, 1e-4);
  }
  EXPECT_GT(feet, points.size() * 9 / 10);
}

TEST(MLSProjector, NormalsTellTheSide)
{
  const auto surface = test::ball(150.0, square);
  const auto sampled = test::sampleUniform(*surface, 8000, 10);
  auto normals = test::toNormals(sampled.normals);
  for (auto& n : *normals)
    n.getNormalVector3fMap() *= -1.0f;
  Projector projector;
  projector.setInputCloud(test::toCloud(sampled.points));
  projector.setInputNormals(normals);
  Cloud::Ptr query(new Cloud);
  query->push_back(pcl::PointXYZ(0, 0, 150));
  projector.setQueryCloud(query);
  pcl::PointCloud<pcl::PointNormal> out;
  projector.compute(out);
  ASSERT_TRUE(projector.getStatus().ok());
  EXPECT_LT(out[0].normal_z, -0.999f);
  EXPECT_NEAR(out[0].curvature, -1.0 / 150.0, 2e-4);
  for (std::size_t i = 0; i < normals->size(); i += 3)
    (*normals)[i].getNormalVector3fMap() *= -1.0f;
  projector.compute(out);
  EXPECT_EQ(projector.getStatus().code(), StatusCode::InvalidInput);
  EXPECT_TRUE(out.empty());
}

TEST(MLSProjector, PublishedMethodPullsInwards)
{
  const auto surface = test::ball(150.0, square);
  Cloud::Ptr query(new Cloud);
  query->push_back(pcl::PointXYZ(0, 0, 150));
  Projector projector;
  projector.setInputCloud(test::toCloud(test::sampleUniform(*surface, 30000, 11).points));
  projector.setQueryCloud(query);
  pcl::PointCloud<pcl::PointNormal> out;
  projector.compute(out);
  EXPECT_NEAR(out[0].z, 150.0, 2e-4);
  projector.setMethod(ProjectionMethod::DirectionalCentroid);
  projector.compute(out);
  EXPECT_LT(out[0].z, 150.0 - 1e-3);
}

TEST(MLSProjector, BadPointsAndFarQueries)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  auto cloud = test::toCloud(test::sampleUniform(*test::ball(150.0, square), 8000, 12).points);
  Projector projector;
  Cloud::Ptr queries(new Cloud);
  for (const float z : {150.2f, 190.0f, nan, 1e30f})
    queries->push_back(pcl::PointXYZ(0, 0, z));
  projector.setQueryCloud(queries);
  projector.setInputCloud(cloud);
  pcl::PointCloud<pcl::PointNormal> clean, out;
  projector.compute(clean);
  Cloud::Ptr soiled(new Cloud(*cloud));
  *soiled += *cloud; // every point twice
  soiled->push_back(pcl::PointXYZ(nan, 0, 0));
  soiled->push_back(pcl::PointXYZ(0, std::numeric_limits<float>::infinity(), 0));
  projector.setInputCloud(soiled);
  projector.compute(out);
  ASSERT_TRUE(projector.getStatus().ok()) << projector.getStatus().message();
  EXPECT_EQ(projector.getValid(), (std::vector<std::uint8_t>{1, 0, 0, 0}));
  EXPECT_FALSE(out.is_dense);
  EXPECT_EQ(out[0].getVector3fMap(), clean[0].getVector3fMap());
  for (std::size_t i = 1; i < 4; ++i)
    EXPECT_TRUE(std::isnan(out[i].x) && std::isnan(out[i].normal_z) && std::isnan(out[i].curvature));
}

TEST(MLSProjector, IndicesChooseTheQueriesAndNotTheSurface)
{
  auto cloud = test::toCloud(test::sampleUniform(*test::ball(150.0, square), 6000, 13).points);
  pcl::IndicesPtr indices(new pcl::Indices);
  for (int i = 0; i < 6000; ++i) {
    (*cloud)[i].z += i % 4 == 1 ? 0.1f : 0.0f; // without the points between, the surface is lower
    if (i % 2 == 0)
      indices->push_back(i);
  }
  const Cloud half(*cloud, *indices);
  Projector projector;
  pcl::PointCloud<pcl::PointNormal> all, chosen, of_half;
  projector.setInputCloud(cloud);
  projector.compute(all);
  projector.setIndices(indices);
  projector.compute(chosen);
  ASSERT_EQ(chosen.size(), 3000u);
  const std::vector<std::uint8_t> valid = projector.getValid();
  Projector other;
  other.setInputCloud(half.makeShared());
  other.compute(of_half);
  float farthest = 0.0f;
  for (std::size_t i = 0; i < chosen.size(); ++i)
    if (valid[i] != 0) {
      ASSERT_LT((chosen[i].getVector3fMap() - all[2 * i].getVector3fMap()).norm(), 1e-4f) << "some steps of single precision";
      if (other.getValid()[i] != 0)
        farthest = std::max(farthest, (chosen[i].getVector3fMap() - of_half[i].getVector3fMap()).norm());
    }
  EXPECT_GT(farthest, 0.02f);
}

TEST(MLSProjector, RefusesWithAReason)
{
  Projector projector;
  pcl::PointCloud<pcl::PointNormal> out;
  const auto refused = [&](StatusCode code) {
    out.resize(3);
    projector.compute(out);
    EXPECT_EQ(projector.getStatus().code(), code) << projector.getStatus().message();
    EXPECT_TRUE(out.empty());
  };
  refused(StatusCode::InvalidInput); // no cloud
  Cloud::Ptr cloud(new Cloud);
  projector.setInputCloud(cloud);
  refused(StatusCode::InvalidInput); // empty
  cloud->resize(100);                // one place
  refused(StatusCode::InvalidInput);
  for (auto& p : *cloud)
    p.x = std::numeric_limits<float>::quiet_NaN();
  refused(StatusCode::InvalidInput);
  projector.setInputCloud(test::toCloud(test::sampleUniform(*test::ball(150.0, square), 1000, 14).points));
  projector.setKSearch(3);
  refused(StatusCode::InvalidArgument);
  projector.setKSearch(0);
  ScannedSurface<pcl::PointXYZ> scanned;
  scanned.setInputCloud(projector.getInputCloud());
  Surface::ConstPtr surface;
  scanned.compute(surface);
  for (const pcl::index_t outside : {5000, 50000000, -1}) {
    projector.setIndices(pcl::IndicesPtr(new pcl::Indices{1, 2, outside}));
    projector.setInputSurface(nullptr);
    refused(StatusCode::InvalidInput);
    projector.setInputSurface(surface);
    refused(StatusCode::InvalidInput);
  }
}

} // namespace
