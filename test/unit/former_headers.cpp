// SPDX-License-Identifier: BSD-3-Clause
// Documented headers at their former paths: each forwards to its present path.
#include <pcl_spiral/toolpath/radial_lines.h>
#include <pcl_spiral/toolpath/spiral_toolpath_generator.h>

#include <gtest/gtest.h>

using namespace pcl_spiral;

TEST(FormerHeaders, BringTheirClasses)
{
  using Point = pcl::PointXYZ;
  EXPECT_FALSE(SpiralToolpathGenerator<Point>().getStatus().message().size() > 1000);
  EXPECT_GT(sizeof(RadialLines<Point>), 0U);
}
