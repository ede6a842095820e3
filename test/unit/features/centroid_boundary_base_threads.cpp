// SPDX-License-Identifier: BSD-3-Clause
// CentroidBoundaryEstimation over a base class with its own number of threads, as in PCL from 2026 on.
#include <pcl/features/boundary.h>
#include <pcl/point_types.h>

/** A point type with the base class below. */
struct NewPoint {
  PCL_ADD_POINT4D;
};
POINT_CLOUD_REGISTER_POINT_STRUCT(NewPoint, (float, x, x)(float, y, y)(float, z, z))

/** The part of the base that CentroidBoundaryEstimation uses, with setNumberOfThreads, which is not virtual. */
template <>
class pcl::BoundaryEstimation<NewPoint, pcl::Normal, pcl::Boundary> : public pcl::FeatureFromNormals<NewPoint, pcl::Normal, pcl::Boundary> {
public:
  using PointCloudOut = pcl::PointCloud<pcl::Boundary>;
  void setNumberOfThreads(unsigned int count = 0) { threads_ = count == 0 ? 4 : count; }
  unsigned int told() const { return threads_; }

protected:
  float angle_threshold_ = 0.0f;
  unsigned int threads_ = 4;
};

#include <pcl_spiral/features/centroid_boundary_estimation.h>

#include <gtest/gtest.h>

using Base = pcl::BoundaryEstimation<NewPoint, pcl::Normal, pcl::Boundary>;
using Estimation = pcl_spiral::CentroidBoundaryEstimation<NewPoint, pcl::Normal>;

TEST(CentroidBoundaryEstimation, ANumberOfThreadsSetInTheBaseCounts)
{
  Estimation estimation;
  Base& base = estimation;
  EXPECT_EQ(estimation.getNumberOfThreads(), 0u);
  estimation.setNumberOfThreads(2);
  EXPECT_EQ(estimation.getNumberOfThreads(), 2u);
  EXPECT_EQ(base.told(), 2u);
  base.setNumberOfThreads(3);
  EXPECT_EQ(estimation.getNumberOfThreads(), 3u);
  estimation.setNumberOfThreads(0);
  EXPECT_EQ(estimation.getNumberOfThreads(), 0u);
  EXPECT_EQ(base.told(), 4u);
}

TEST(CentroidBoundaryEstimation, ANumberNobodyMeansIsRefusedHoweverSet)
{
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  pcl::PointCloud<NewPoint>::Ptr cloud(new pcl::PointCloud<NewPoint>);
  for (int i = 0; i < 400; ++i) {
    NewPoint p;
    p.x = static_cast<float>(i % 20), p.y = static_cast<float>(i / 20), p.z = 0.0f;
    cloud->push_back(p);
  }
  Estimation estimation;
  Base& base = estimation;
  base.setInputCloud(cloud);
  base.setInputNormals(pcl::PointCloud<pcl::Normal>::Ptr(new pcl::PointCloud<pcl::Normal>(400, 1, pcl::Normal(0, 0, 1))));
  base.setKSearch(16);
  pcl::PointCloud<pcl::Boundary> flags;
  base.setNumberOfThreads(-1);
  base.compute(flags);
  EXPECT_EQ(estimation.getStatus().code(), pcl_spiral::StatusCode::InvalidArgument);
  base.setNumberOfThreads(1);
  base.compute(flags);
  EXPECT_TRUE(estimation.getStatus().ok()) << estimation.getStatus().message();
  EXPECT_EQ(flags.size(), 400u);
}
