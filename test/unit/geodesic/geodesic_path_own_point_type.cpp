// SPDX-License-Identifier: BSD-3-Clause
// GeodesicPath on a point type that PCL does not know, with only its own header: also a link test.
#include <pcl_spiral/geodesic/geodesic_path.h>

#include <pcl/register_point_struct.h>

#include <gtest/gtest.h>

struct EIGEN_ALIGN16 PointWithConfidence {
  PCL_ADD_POINT4D;
  float confidence = 0.0f;
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};
POINT_CLOUD_REGISTER_POINT_STRUCT(PointWithConfidence, (float, x, x)(float, y, y)(float, z, z)(float, confidence, confidence))

TEST(GeodesicPathOwnPointType, StraightOnAPlane)
{
  auto cloud = pcl::make_shared<pcl::PointCloud<PointWithConfidence>>();
  for (int i = 0; i < 30; ++i)
    for (int j = 0; j < 30; ++j) {
      PointWithConfidence point;
      point.getVector3fMap() = Eigen::Vector3f(i + 0.2f * (j % 2), j, 0.0f);
      cloud->push_back(point);
    }
  pcl_spiral::GeodesicPath<PointWithConfidence> path;
  path.setInputCloud(cloud);
  path.setSourcePoint({5.0, 5.0, 0.0});
  path.setTargetPoints({{20.0, 25.0, 0.0}});
  std::vector<pcl_spiral::Polyline> lines;
  path.compute(lines);
  ASSERT_TRUE(path.getStatus().ok()) << path.getStatus().message();
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NEAR(pcl_spiral::length(lines[0]), 25.0, 1e-3);
}
