// SPDX-License-Identifier: BSD-3-Clause
// Paths of tips and axes from text files, and the tips of a .vtp.
#include <pcl_spiral/core/impl/pass_ranges.h>
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/toolpath_reader.h>
#include <pcl_spiral/io/toolpath_writer.h>

#include "support/scratch_folder.h"

#include <gtest/gtest.h>

namespace tip_files_test {

using namespace pcl_spiral;

namespace {

ToolpathFile
readOf(const std::string& text, const Eigen::Vector3d& origin = Eigen::Vector3d::Zero())
{
  const ScratchFolder folder;
  writeText(folder.path("tips.csv"), text);
  return readToolpath(folder.path("tips.csv"), origin);
}

std::string
refusalOf(const std::string& text)
{
  try {
    readOf(text);
  }
  catch (const FileError& error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST(TipFiles, AreReadWithEveryHeader)
{
  const std::string rows = "1,2,3,0,0,2\n1,2,5,0,1,0\n";
  for (const std::string header :
       {"", "x,y,z,i,j,k\n", "X,Y,Z,I,J,K\n", "tip_x,tip_y,tip_z,axis_x,axis_y,axis_z\n", "# made by hand\nx,y,z,i,j,k\n"}) {
    const ToolpathFile file = readOf(header + rows, {1.0, 0.0, 0.0});
    EXPECT_FALSE(file.has_contacts) << header;
    ASSERT_EQ(file.tips.size(), 2u) << header;
    EXPECT_EQ(file.tips[1], Eigen::Vector3d(0.0, 2.0, 5.0));
    EXPECT_EQ(file.path[0].getAxisVector3fMap(), Eigen::Vector3f::UnitZ()); // made unit
    EXPECT_EQ(file.path[1].getAxisVector3fMap(), Eigen::Vector3f::UnitY());
    EXPECT_EQ(file.path[1].arc_length, 2.0);
    EXPECT_TRUE(file.feed.empty());
  }
}

TEST(TipFiles, ALiftIsBetweenPasses)
{
  const ToolpathFile file = readOf("pass,x,y,z,i,j,k,feed\n0,0,0,0,0,0,1,100\n0,1,0,0,0,0,1,200\n1,5,0,0,0,0,1,300\n1,6,0,0,0,0,1,400\n");
  EXPECT_EQ(passBegins(file.path), std::vector<std::size_t>{2});
  EXPECT_EQ(file.path.back().arc_length, 2.0);
  EXPECT_EQ(file.feed, (std::vector<double>{100.0, 200.0, 300.0, 400.0}));
}

TEST(TipFiles, FaultsAreNamed)
{
  EXPECT_NE(refusalOf("x,y,z,i,j,k\n0,0,0,0,0,1\n0,0,1,0,0,0\n").find("point 2 has no tool axis"), std::string::npos);
  EXPECT_NE(refusalOf("x,y,z,i,j\n0,0,0,0,0\n").find("k"), std::string::npos);
}

TEST(TipFiles, AVtpKeepsItsTipsAndPasses)
{
  pcl::PointCloud<ToolpathPoint> path;
  ToolpathMotion motion;
  for (int i = 0; i < 6; ++i) {
    ToolpathPoint point;
    point.x = static_cast<float>(i);
    point.normal_z = point.axis_z = 1.0f;
    point.arc_length = i < 3 ? i : i - 1.0; // no cut to the fourth
    path.push_back(point);
    motion.tips.push_back({i + 0.25, -1.0, 0.5});
  }
  motion.passes = {3};
  motion.origin = {1e6, 0.0, 0.0};
  const ScratchFolder folder;
  writeToolpath(folder.path("rows.vtp"), path, motion);
  const ToolpathFile read = readToolpath(folder.path("rows.vtp"), motion.origin);
  EXPECT_TRUE(read.has_contacts);
  EXPECT_EQ(read.tips, motion.tips);
  EXPECT_EQ(passBegins(read.path), std::vector<std::size_t>{3});
}

} // namespace tip_files_test
