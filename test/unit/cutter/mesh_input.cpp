// SPDX-License-Identifier: BSD-3-Clause
// Stages that take a cloud, a surface or a mesh: the last input set counts.
#include <pcl_spiral/cutter/cutter_location.h>
#include <pcl_spiral/drive/drive_path.h>
#include <pcl_spiral/verify/deviation_estimation.h>
#include <pcl_spiral/verify/material_removal.h>

#include "support/judged_meshes.h"

#include <gtest/gtest.h>

namespace mesh_input_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Values = pcl::PointCloud<pcl::PointXYZI>;

double
flat(double, double)
{
  return 0.0;
}

/** A grid of points in z = 0, 0.5 apart. */
Cloud::Ptr
plane()
{
  const Cloud::Ptr cloud(new Cloud);
  for (int i = -20; i <= 20; ++i)
    for (int j = -20; j <= 20; ++j)
      cloud->push_back(pcl::PointXYZ(0.5f * static_cast<float>(i), 0.5f * static_cast<float>(j), 0.0f));
  return cloud;
}

/** Rows over the plane. */
pcl::PointCloud<ToolpathPoint>::Ptr
path()
{
  const pcl::PointCloud<ToolpathPoint>::Ptr result(new pcl::PointCloud<ToolpathPoint>);
  for (int row = -8; row <= 8; ++row)
    for (int i = -16; i <= 16; ++i) {
      ToolpathPoint p;
      p.getVector3fMap() = Eigen::Vector3f(0.5f * static_cast<float>(row % 2 == 0 ? i : -i), static_cast<float>(row), 0.0f);
      p.getNormalVector3fMap() = p.getAxisVector3fMap() = Eigen::Vector3f::UnitZ();
      p.arc_length = result->empty() ? 0.0f : result->back().arc_length + (result->back().getVector3fMap() - p.getVector3fMap()).norm();
      result->push_back(p);
    }
  return result;
}

/** \p prepared stage, whose compute gives \p Output. */
template <typename Output, typename Stage>
void
expectLastInputCounts(Stage& stage)
{
  const auto message = [&] {
    Output output;
    stage.compute(output);
    return stage.getStatus().message();
  };
  stage.setInputCloud(plane());
  stage.setInputMesh(SurfaceMesh::ConstPtr());
  EXPECT_NE(message().find("input mesh is missing"), std::string::npos) << message();
  stage.setInputMesh(pcl::PolygonMesh::ConstPtr());
  EXPECT_NE(message().find("input mesh is missing"), std::string::npos) << message();
  stage.setInputMesh(heightMesh(flat, 20.0, 8).made());
  EXPECT_EQ(message(), Status::success().message());
  stage.setInputCloud(Cloud::ConstPtr(new Cloud));
  EXPECT_NE(message().find("input cloud is missing"), std::string::npos) << message();
  stage.setInputCloud(plane());
  EXPECT_EQ(message(), Status::success().message());
}

} // namespace

TEST(MeshInput, TheLastInputCountsForCutters)
{
  CutterLocation<pcl::PointXYZ> location;
  location.setQuiet(true);
  location.setCutter(CutterShape::ball(3.0));
  location.setDrivePath(*path());
  expectLastInputCounts<ToolLocations>(location);
}

TEST(MeshInput, TheLastInputCountsForDrivePaths)
{
  DrivePath<pcl::PointXYZ> drive;
  drive.setQuiet(true);
  drive.setStepOver(1.0);
  expectLastInputCounts<DrivePasses>(drive);
}

TEST(MeshInput, TheLastInputCountsForDeviations)
{
  DeviationEstimation<pcl::PointXYZ> judge;
  judge.setQuiet(true);
  judge.setInputToolpath(path());
  expectLastInputCounts<Values>(judge);
}

TEST(MeshInput, MaterialIsJudgedAtTheSamplesOfAMeshGivenAfterACloud)
{
  MaterialRemoval<pcl::PointXYZ> judge;
  judge.setQuiet(true);
  judge.setInputToolpath(path());
  judge.setToolRadius(5.0);
  judge.setScallopHeight(0.05);
  judge.setSampleSpacing(0.4);
  expectLastInputCounts<Values>(judge);
  judge.setInputMesh(heightMesh(flat, 20.0, 8).made());
  Values output;
  judge.compute(output);
  ASSERT_TRUE(judge.getStatus().ok()) << judge.getStatus().message();
  EXPECT_NE(output.size(), plane()->size());
  EXPECT_EQ(judge.getInputCloud(), nullptr);
}

} // namespace mesh_input_test
