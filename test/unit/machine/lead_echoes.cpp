// SPDX-License-Identifier: BSD-3-Clause
// A lone point over a lead is told from a clamp: against the figures of the same scan made without it.
#include <pcl_spiral/machine/machine_program_generator.h>
#include <pcl_spiral/verify/lead_check.h>

#include "support/test_machines.h"

#include <gtest/gtest.h>

#include <random>

namespace lead_echoes_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/** Over the floor z = 0 from x = 0 to x = -10, the axis up. */
MachineProgram
overTheFloor()
{
  ToolPoses poses;
  for (int i = 0; i <= 10; ++i) {
    ToolPose pose;
    pose.contact = pose.tip = {-1.0 * i, 0.0, 0.0};
    pose.normal = pose.axis = Eigen::Vector3d::UnitZ();
    poses.push_back(pose);
  }
  MachineProgramGenerator generator;
  generator.setMachine(testMachines().front());
  generator.setInputPasses({poses});
  MachineProgram program;
  generator.compute(program);
  EXPECT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
  return program;
}

/** A floor with a point every mm or so. */
Cloud
scannedFloor()
{
  std::mt19937 random(2);
  std::uniform_real_distribution<float> jitter(-0.3f, 0.3f);
  Cloud cloud;
  for (int i = -30; i <= 20; ++i)
    for (int k = -20; k <= 20; ++k)
      cloud.push_back({static_cast<float>(i) + jitter(random), static_cast<float>(k) + jitter(random), 0.0f});
  return cloud;
}

/** \p count points 0.8 mm apart in a block, the first at \p corner. */
Cloud
block(const pcl::PointXYZ& corner, int count)
{
  constexpr float step = 0.8f;
  Cloud points;
  for (int i = 0; i < count; ++i)
    points.push_back({corner.x + step * static_cast<float>(i % 5), corner.y + step * static_cast<float>(i / 5 % 3),
                      corner.z + step * static_cast<float>(i / 15)});
  return points;
}

Cloud
joined(Cloud cloud, const Cloud& more)
{
  cloud += more;
  return cloud;
}

LeadCheck<pcl::PointXYZ>
checked(const Cloud& cloud, std::size_t echo = largest_echo, unsigned int threads = 2)
{
  LeadCheck<pcl::PointXYZ> check;
  check.setInputCloud(pcl::make_shared<Cloud>(cloud));
  check.setCutter(CutterShape::ball(3.0));
  check.setLargestEcho(echo);
  check.setNumberOfThreads(threads);
  check.compute(overTheFloor());
  EXPECT_TRUE(check.getStatus().ok()) << check.getStatus().message();
  return check;
}

void
expectSame(const LeadReport& one, const LeadReport& other)
{
  EXPECT_EQ(one.moves, other.moves);
  EXPECT_EQ(one.collided, other.collided);
  EXPECT_EQ(one.deepest.depth, other.deepest.depth);
  EXPECT_EQ(one.deepest.place, other.deepest.place);
  EXPECT_EQ(one.deepest.block, other.deepest.block);
}

} // namespace

TEST(LeadEchoes, AnEchoStandsInNoOnesWayAClampDoes)
{
  const Cloud floor = scannedFloor();
  ASSERT_EQ(checked(floor).getReport().collided, 0U);
  for (const int points : {1, 2, 3, 4, 30}) {
    const auto check = checked(joined(floor, block({0.0f, 0.0f, 5.0f}, points)));
    EXPECT_GT(check.getReport().collided, 0U) << points;
    if (points <= 3)
      expectSame(check.getObstacleReport(), checked(floor).getReport());
    else
      expectSame(check.getObstacleReport(), check.getReport());
  }
}

TEST(LeadEchoes, WhatRemainsIsTheScanWithoutItsEchoes)
{
  const Cloud clamped = joined(scannedFloor(), block({0.5f, 2.0f, 6.0f}, 30)), echo = block({-10.0f, 0.0f, 5.0f}, 1);
  const auto check = checked(joined(clamped, echo));
  EXPECT_EQ(check.getReport().deepest.place, Eigen::Vector3d(-10.0, 0.0, 5.0)) << "the echo is deeper in the tool";
  expectSame(check.getObstacleReport(), checked(clamped, 0).getReport());
  EXPECT_GT(check.getObstacleReport().collided, 0U);
  EXPECT_LT(check.getObstacleReport().collided, check.getReport().collided);
  expectSame(check.getObstacleReport(), checked(joined(echo, clamped), largest_echo, 1).getObstacleReport());
}

TEST(LeadEchoes, EveryPointIsAnObstacleUnlessAskedAndWithoutASurface)
{
  const auto unasked = checked(joined(scannedFloor(), block({0.0f, 0.0f, 5.0f}, 1)), 0);
  EXPECT_GT(unasked.getObstacleReport().collided, 0U);
  expectSame(unasked.getObstacleReport(), unasked.getReport());
  const auto alone = checked(block({0.0f, 0.0f, 5.0f}, 2));
  EXPECT_GT(alone.getObstacleReport().collided, 0U);
  expectSame(alone.getObstacleReport(), alone.getReport());
}

TEST(LeadEchoes, IndicesChooseTheScanAndTheRepeatedCheckCanBeCancelled)
{
  const auto cloud = pcl::make_shared<Cloud>(joined(scannedFloor(), block({0.0f, 0.0f, 5.0f}, 31)));
  const auto indices = pcl::make_shared<pcl::Indices>();
  for (std::size_t i = 0; i + 30 < cloud->size(); ++i)
    indices->push_back(static_cast<pcl::index_t>(i)); // one point of the block
  LeadCheck<pcl::PointXYZ> check;
  check.setInputCloud(cloud);
  check.setIndices(indices);
  check.setCutter(CutterShape::ball(3.0));
  check.setLargestEcho(largest_echo);
  const MachineProgram program = overTheFloor();
  int begun = 0;
  check.setProgressCallback([&](double share, const std::string&) { return (begun += share == 0.0) < 3; });
  check.compute(program);
  EXPECT_EQ(begun, 2);
  EXPECT_GT(check.getReport().collided, 0U);
  EXPECT_EQ(check.getObstacleReport().collided, 0U);
  begun = 1;
  check.compute(program);
  EXPECT_EQ(check.getStatus().code(), StatusCode::Cancelled);
  EXPECT_EQ(check.getReport().collided, 0U) << "nothing is known when cancelled";
}

} // namespace lead_echoes_test
