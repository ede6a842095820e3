// SPDX-License-Identifier: BSD-3-Clause
// Headers by the places they had: each forwards to where it is now.
#include <pcl_spiral/surface/stray_removal.h>
#include <pcl_spiral/toolpath/axis_field.h>
#include <pcl_spiral/toolpath/cutter_location.h>
#include <pcl_spiral/toolpath/drive_pass.h>
#include <pcl_spiral/toolpath/drive_path.h>
#include <pcl_spiral/toolpath/drive_settings.h>
#include <pcl_spiral/toolpath/radial_lines.h>
#include <pcl_spiral/toolpath/spiral_report.h>
#include <pcl_spiral/toolpath/spiral_settings.h>
#include <pcl_spiral/toolpath/spiral_toolpath_generator.h>
#include <pcl_spiral/toolpath/tool_axis.h>
#include <pcl_spiral/toolpath/tool_location.h>

#include <gtest/gtest.h>

using namespace pcl_spiral;

TEST(FormerHeaders, BringTheirClasses)
{
  using Point = pcl::PointXYZ;
  EXPECT_FALSE(SpiralToolpathGenerator<Point>().getStatus().message().size() > 1000);
  EXPECT_GT(sizeof(StrayRemoval<Point>) + sizeof(CutterLocation<Point>) + sizeof(DrivePath<Point>) + sizeof(RadialLines<Point>) +
                sizeof(DrivePass) + sizeof(DriveSettings) + sizeof(SpiralReport) + sizeof(SpiralSettings) + sizeof(ToolLocation),
            0U);
}
