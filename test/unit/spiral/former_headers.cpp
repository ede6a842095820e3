// SPDX-License-Identifier: BSD-3-Clause
// Documented headers at their former paths: each forwards to its present path.
#include <pcl_spiral/cleaning/stray_removal.h>
#include <pcl_spiral/features/boundary_loops.h>
#include <pcl_spiral/spiral/spiral_turns.h>
#include <pcl_spiral/surface/stray_removal.h>
#include <pcl_spiral/surface/surface_foot.h>
#include <pcl_spiral/toolpath/cutter_location.h>
#include <pcl_spiral/toolpath/drive_path.h>
#include <pcl_spiral/toolpath/radial_lines.h>
#include <pcl_spiral/toolpath/spiral_toolpath_generator.h>
#include <pcl_spiral/toolpath/tool_axis.h>

#include <gtest/gtest.h>

#include <type_traits>

using namespace pcl_spiral;

TEST(FormerHeaders, BringTheirClasses)
{
  using Point = pcl::PointXYZ;
  EXPECT_FALSE(SpiralToolpathGenerator<Point>().getStatus().message().size() > 1000);
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
  EXPECT_GT(sizeof(StrayRemoval<Point>), 0U);
#pragma GCC diagnostic pop
  EXPECT_GT(sizeof(SurfaceFoot), 0U);
  EXPECT_GT(sizeof(CutterLocation<Point>), 0U);
  EXPECT_GT(sizeof(DrivePath<Point>), 0U);
  EXPECT_GT(sizeof(RadialLines<Point>), 0U);
  EXPECT_GT(sizeof(ToolAxis), 0U);
  EXPECT_GT(sizeof(SpiralTurns), 0U);
}

#pragma GCC diagnostic ignored "-Wdeprecated-declarations"

TEST(FormerNames, ReportsHaveThem)
{
  static_assert(std::is_same_v<SurfaceCounts, SurfaceReport> && std::is_same_v<PathFigures, ToolpathReport> &&
                std::is_same_v<PathCounts, SpiralPathReport>);
  OutlierRemoval<pcl::PointXYZ> removal;
  EXPECT_EQ(&removal.getFigures(), &removal.getReport());
  BoundaryLoops<pcl::PointXYZ> boundary;
  EXPECT_EQ(&boundary.getCounts(), &boundary.getReport());
}
