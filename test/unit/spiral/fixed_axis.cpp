// SPDX-License-Identifier: BSD-3-Clause
// One tool axis for a whole spiral: the contacts are those of any other axis, and a surface that the shank would touch is refused.
#include "support/sampling.h"

#include <pcl_spiral/spiral/spiral_toolpath_generator.h>

#include <gtest/gtest.h>

namespace fixed_axis_test {

namespace {

using namespace pcl_spiral;
using Path = pcl::PointCloud<ToolpathPoint>;

constexpr double radius = 80.0;

/** The cap of a ball, out to \p reach from its axis. */
test::Sampled
cap(double reach)
{
  return test::sampleUniform(*test::ball(radius, test::Region({test::circle({0, 0}, reach)})), 4000, 31);
}

Status
compute(const test::Sampled& scan, SpiralMethod method, const std::optional<Eigen::Vector3d>& axis, Path& path)
{
  SpiralToolpathGenerator<pcl::PointXYZ> spiral;
  spiral.setInputCloud(test::toCloud(scan.points));
  spiral.setMethod(method);
  spiral.setToolRadius(6.0);
  spiral.setScallopHeight(0.1);
  spiral.setChordError(0.01);
  if (axis)
    spiral.setFixedAxis(*axis);
  spiral.compute(path);
  return spiral.getStatus();
}

} // namespace

TEST(FixedAxis, ContactsStayAndEveryAxisIsTheSame)
{
  const test::Sampled scan = cap(30.0);
  const Eigen::Vector3d axis(0.0, 0.6, 1.8);
  for (const SpiralMethod method : {SpiralMethod::Radial, SpiralMethod::ConstantScallop}) {
    Path tilted, fixed;
    ASSERT_TRUE(compute(scan, method, {}, tilted).ok());
    ASSERT_TRUE(compute(scan, method, axis, fixed).ok());
    ASSERT_EQ(fixed.size(), tilted.size());
    for (std::size_t i = 0; i < fixed.size(); ++i) {
      ASSERT_EQ(fixed[i].getVector3fMap(), tilted[i].getVector3fMap());
      ASSERT_LT((fixed[i].getAxisVector3fMap().cast<double>() - axis.normalized()).norm(), 1e-6);
    }
  }
}

/** At the rim of a cap of ball the normal leans by asin(reach / radius) from z. */
TEST(FixedAxis, WhereTheShankWouldTouchItIsRefusedWithThePlace)
{
  const test::Sampled scan = cap(50.0); // 38.7 degrees
  Path path;
  EXPECT_TRUE(compute(scan, SpiralMethod::Radial, Eigen::Vector3d(std::sin(0.8), 0.0, std::cos(0.8)), path).ok()) << "45.8 + 38.7 degrees";
  const Status status = compute(scan, SpiralMethod::Radial, Eigen::Vector3d(std::sin(1.0), 0.0, std::cos(1.0)), path); // 57.3 + 38.7
  EXPECT_FALSE(status.ok());
  EXPECT_TRUE(path.empty());
  EXPECT_NE(status.message().find("the fixed tool axis leans 9"), std::string::npos) << status.message();
  EXPECT_NE(status.message().find("the shank would touch the part: choose another axis (setFixedAxis)"), std::string::npos);
}

TEST(FixedAxis, ADirectionWithoutLengthIsRefused)
{
  Path path;
  const Status status = compute(cap(30.0), SpiralMethod::Radial, Eigen::Vector3d::Zero(), path);
  EXPECT_EQ(status.code(), StatusCode::InvalidArgument);
  EXPECT_NE(status.message().find("give a direction such as (0, 0, 1)"), std::string::npos) << status.message();
}

} // namespace fixed_axis_test
