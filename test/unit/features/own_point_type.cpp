// SPDX-License-Identifier: BSD-3-Clause
// The filters on a point type that PCL does not know, with only their own headers.
#include <pcl_spiral/features/centroid_boundary_estimation.h>
#include <pcl_spiral/search/elliptic_gabriel_graph.h>
#include <pcl_spiral/spiral/loop_linking.h>
#include <pcl_spiral/surface/surface_preparation.h>

#include <gtest/gtest.h>

#include <random>

struct OwnPoint {
  PCL_ADD_POINT4D;
  float reflectance = 0.0f;
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};
POINT_CLOUD_REGISTER_POINT_STRUCT(OwnPoint, (float, x, x)(float, y, y)(float, z, z)(float, reflectance, reflectance))

namespace {

/** The same random square in both types. */
struct Clouds {
  pcl::PointCloud<OwnPoint>::Ptr own{new pcl::PointCloud<OwnPoint>};
  pcl::PointCloud<pcl::PointXYZ>::Ptr plain{new pcl::PointCloud<pcl::PointXYZ>};
  pcl::PointCloud<pcl::Normal>::Ptr normals{new pcl::PointCloud<pcl::Normal>(900, 1, pcl::Normal(0, 0, 1))};

  Clouds()
  {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> side(0.0f, 30.0f);
    for (int i = 0; i < 900; ++i) {
      plain->push_back(pcl::PointXYZ(side(random), side(random), 0.0f));
      own->emplace_back();
      own->back().getVector3fMap() = plain->back().getVector3fMap();
    }
  }
};

} // namespace

TEST(OwnPointType, CentroidBoundaryEstimationThroughTheBaseClass)
{
  const Clouds clouds;
  pcl_spiral::CentroidBoundaryEstimation<OwnPoint, pcl::Normal> estimation;
  pcl::Feature<OwnPoint, pcl::Boundary>& feature = estimation;
  feature.setInputCloud(clouds.own);
  estimation.setInputNormals(clouds.normals);
  feature.setKSearch(32);
  pcl::PointCloud<pcl::Boundary> out, expected;
  feature.compute(out);
  ASSERT_TRUE(estimation.getStatus().ok());
  pcl_spiral::CentroidBoundaryEstimation<pcl::PointXYZ, pcl::Normal> plain;
  plain.setInputCloud(clouds.plain);
  plain.setInputNormals(clouds.normals);
  plain.setKSearch(32);
  plain.compute(expected);
  EXPECT_EQ(estimation.getOffsets(), plain.getOffsets());
  for (std::size_t i = 0; i < out.size(); ++i)
    EXPECT_EQ(out[i].boundary_point, expected[i].boundary_point);
}

TEST(OwnPointType, EllipticGabrielGraph)
{
  const Clouds clouds;
  pcl_spiral::EllipticGabrielGraph<OwnPoint> egg;
  egg.setInputCloud(clouds.own);
  pcl_spiral::NeighbourLists graph, expected;
  egg.compute(graph);
  pcl_spiral::EllipticGabrielGraph<pcl::PointXYZ> plain;
  plain.setInputCloud(clouds.plain);
  plain.compute(expected);
  ASSERT_EQ(graph.edgeCount(), expected.edgeCount());
  for (std::uint32_t i = 0; i < graph.size(); ++i)
    for (const std::uint32_t j : expected[i])
      EXPECT_TRUE(graph.contains(i, j));
}

TEST(OwnPointType, SurfacePreparationKeepsItsFields)
{
  const Clouds clouds;
  for (std::size_t i = 0; i < clouds.own->size(); ++i)
    (*clouds.own)[i].reflectance = static_cast<float>(i);
  pcl_spiral::SurfacePreparation<OwnPoint> preparation;
  preparation.setInputCloud(clouds.own);
  pcl::PointCloud<OwnPoint> out;
  pcl::PointCloud<pcl::Normal> normals;
  preparation.compute(out, normals);
  ASSERT_TRUE(preparation.getStatus().ok()) << preparation.getStatus().message();
  ASSERT_EQ(out.size(), 900u);
  for (std::size_t i = 0; i < out.size(); ++i)
    EXPECT_EQ(out[i].reflectance, static_cast<float>(preparation.getSourceIndices()[i]));
}

TEST(OwnPointType, LoopLinkingFromACloud)
{
  const Clouds clouds;
  pcl_spiral::LinkedPath path, expected;
  const auto link = [](auto& linking, const auto& cloud, pcl_spiral::LinkedPath& linked) {
    linking.setInputCloud(cloud);
    linking.setToolRadius(5.0);
    linking.setScallopHeight(0.1);
    linking.compute(linked);
    EXPECT_TRUE(linking.getStatus().ok()) << linking.getStatus().message();
  };
  pcl_spiral::LoopLinking<OwnPoint> own;
  pcl_spiral::LoopLinking<pcl::PointXYZ> plain;
  link(own, clouds.own, path);
  link(plain, clouds.plain, expected);
  EXPECT_GT(path.points.size(), 100u);
  EXPECT_EQ(path.points, expected.points);
}
