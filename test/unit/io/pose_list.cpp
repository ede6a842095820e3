// SPDX-License-Identifier: BSD-3-Clause
// Lists of poses, .6d and .5d, read back by a parser of the test and checked with kinematics of the tests.
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/path_exchange.h>

#include "core/angle_between.h"
#include "support/dome_spiral.h"
#include "support/scratch_folder.h"
#include "support/test_machines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <locale>
#include <regex>
#include <sstream>

namespace pose_list_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

using Rows = std::vector<std::vector<std::vector<double>>>;

/** Rows of lines of numbers; every line ends, with one empty line between rows. */
Rows
readRows(const std::string& file)
{
  static const std::regex shape("-?[0-9]+\\.[0-9]+( -?[0-9]+\\.[0-9]+)*");
  std::istringstream lines(readText(file));
  Rows rows(1);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty()) {
      EXPECT_FALSE(rows.back().empty()) << "two blank lines";
      rows.emplace_back();
      continue;
    }
    EXPECT_TRUE(std::regex_match(line, shape)) << line;
    std::istringstream words(line);
    words.imbue(std::locale::classic());
    rows.back().emplace_back();
    for (double value; words >> value;)
      rows.back().back().push_back(value);
  }
  EXPECT_FALSE(rows.back().empty()) << "a blank line at the end";
  return rows;
}

/** A straight pass over a dome with the axis along its normal, \p offset beside the pole. */
ToolPoses
overThePole(double offset)
{
  ToolPoses poses;
  for (int i = -40; i <= 40; ++i) {
    ToolPose pose;
    pose.normal = Eigen::Vector3d(i / 200.0, offset / 200.0, 1.0).normalized();
    pose.axis = pose.normal;
    pose.contact = 200.0 * pose.normal;
    pose.tip = pose.contact + 10.0 * pose.normal;
    poses.push_back(pose);
  }
  return poses;
}

ToolPoses
upright()
{
  ToolPoses poses(20);
  for (std::size_t i = 0; i < poses.size(); ++i)
    poses[i].tip = poses[i].contact = {-5.0 * static_cast<double>(i), 1.0 / 3.0, -1e-9};
  return poses;
}

/** Over the pole and beside it, ten turns, and poses without an angle, also at start and end. */
std::vector<ToolPoses>
hardRows()
{
  const ToolPoses dome = domeSpiral(200.0, 4.0, 10, 40, 6.0, 13.0);
  const ToolPoses around(dome.begin() + 20, dome.end()), back(around.rbegin(), around.rend());
  return {upright(), dome, overThePole(0.0), overThePole(0.2), upright(), around, back, overThePole(30.0), upright()};
}

std::string
refusal(const std::string& file, const std::vector<ToolPoses>& rows, void (*write)(const std::string&, const std::vector<ToolPoses>&))
{
  try {
    write(file, rows);
  }
  catch (const FileError& error) {
    return error.what();
  }
  return "written";
}

} // namespace

TEST(PoseList, VectorsSayTipAndAxis)
{
  const ScratchFolder folder;
  const std::vector<ToolPoses> rows = hardRows();
  writePoseVectors(folder.path("a.6d"), rows);
  const Rows read = readRows(folder.path("a.6d"));
  ASSERT_EQ(read.size(), rows.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    ASSERT_EQ(read[k].size(), rows[k].size());
    for (std::size_t i = 0; i < rows[k].size(); ++i) {
      const std::vector<double>& v = read[k][i];
      ASSERT_EQ(v.size(), 6U);
      ASSERT_LT((Eigen::Vector3d(v[0], v[1], v[2]) - rows[k][i].tip).norm(), 1e-3);
      ASSERT_LT(angleBetween(Eigen::Vector3d(v[3], v[4], v[5]).normalized(), rows[k][i].axis), 1e-3 * M_PI / 180.0);
    }
  }
}

TEST(PoseList, AnglesAreThoseOfTheTrunnionAndGoOn)
{
  const ScratchFolder folder;
  const std::vector<ToolPoses> rows = hardRows();
  writePoseAngles(folder.path("a.5d"), rows);
  const Rows read = readRows(folder.path("a.5d"));
  ASSERT_EQ(read.size(), rows.size());
  MachineChain chain; // C on a trunnion A, as in LinuxCNC's xyzac-trt
  chain.rotary = {{'C', true, Eigen::Vector3d::UnitZ(), Eigen::Vector3d::Zero()},
                  {'A', true, Eigen::Vector3d::UnitX(), Eigen::Vector3d::Zero()}};
  double before = 0.0, lowest = 0.0, highest = 0.0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    ASSERT_EQ(read[k].size(), rows[k].size());
    for (std::size_t i = 0; i < rows[k].size(); ++i) {
      const std::vector<double>& v = read[k][i];
      ASSERT_EQ(v.size(), 5U);
      ASSERT_LT((Eigen::Vector3d(v[0], v[1], v[2]) - rows[k][i].tip).norm(), 1e-3);
      const Eigen::Vector3d axis = forward(chain, {Eigen::Vector3d::Zero(), v[4], v[3]}).axis;
      ASSERT_LT(angleBetween(axis, rows[k][i].axis), 1e-3 * M_PI / 180.0) << k << ' ' << i;
      ASSERT_LE(std::abs(v[4] - before), 90.0 + 1e-5) << "row " << k << " pose " << i;
      before = v[4];
      lowest = std::min(lowest, before);
      highest = std::max(highest, before);
    }
  }
  EXPECT_GT(highest - lowest, 360.0 * 9.0);
  for (std::size_t i = 1; i < read[4].size(); ++i)
    EXPECT_EQ(read[4][i][4], read[3].back()[4]) << "an upright axis leaves C where it stands";
}

TEST(PoseList, BytesDependOnThePosesAlone)
{
  class CommaPoint : public std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  const ScratchFolder folder;
  const auto all = [&folder] {
    writePoseVectors(folder.path("a.6d"), hardRows());
    writePoseAngles(folder.path("a.5d"), hardRows());
    return readText(folder.path("a.6d")) + readText(folder.path("a.5d"));
  };
  const std::string plain = all();
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new CommaPoint));
  const std::string comma = all();
  std::locale::global(before);
  EXPECT_TRUE(plain == comma);
  EXPECT_EQ(plain.rfind("0.000000 0.333333 0.000000 0.00000000 0.00000000 1.00000000\n", 0), 0U);
}

TEST(PoseList, WhatCannotBeWrittenIsNamed)
{
  const ScratchFolder folder;
  const std::string file = folder.path("a.5d");
  for (const auto write : {writePoseVectors, writePoseAngles}) {
    const auto expectRefused = [&](const std::vector<ToolPoses>& rows, const std::string& words) {
      const std::string message = refusal(file, rows, write);
      EXPECT_NE(message.find(words), std::string::npos) << "'" << words << "' in: " << message;
      EXPECT_EQ(folder.count(), 0U);
    };
    expectRefused({}, "there are no poses");
    expectRefused({{}}, "row 1 has 0 poses; give it two or more, or leave it out");
    expectRefused({upright(), {ToolPose()}}, "row 2 has 1 poses");
    ToolPoses wrong = upright();
    wrong[3].axis = {0.0, 0.0, 2.0};
    expectRefused({upright(), wrong}, "row 2 has a pose at (-15, 0.333, 0) that is not finite, or its axis (0, 0, 2) is not a unit vector");
    wrong[3].axis = Eigen::Vector3d::UnitZ();
    wrong[3].tip.x() = std::numeric_limits<double>::quiet_NaN();
    expectRefused({wrong}, "not finite");
    wrong.erase(wrong.begin() + 3); // the remedy
    EXPECT_EQ(refusal(folder.path("b"), {wrong}, write), "written");
    std::filesystem::remove(folder.path("b"));
    EXPECT_NE(refusal(folder.path("none/a.5d"), {upright()}, write).find("cannot be written"), std::string::npos);
  }
}

} // namespace pose_list_test
