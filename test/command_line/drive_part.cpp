// SPDX-License-Identifier: BSD-3-Clause
// pcl_spiral_drive on a scan with more than the part: the leaning tool beside a clamp that is kept out of, cropped away, or there; and
// several regions in one run. The tool of every path is tried against every point by brute force.
#include <pcl_spiral/io/machine_reader.h>
#include <pcl_spiral/io/program_reader.h>
#include <pcl_spiral/io/toolpath_reader.h>

#include "run_program.h"
#include "two_domes.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <sstream>

namespace drive_part_test {

namespace {

using Eigen::Vector3d;
using Arguments = std::vector<std::string>;

constexpr double ball = 3.0;

/** A floor at z = 0, and the top of a clamp: a rectangle at some height over a hole in the floor. */
struct Bench {
  double x0, x1, y, height;
  double floor_end = 32.0; ///< along x

  std::vector<Vector3d> clamp() const
  {
    std::vector<Vector3d> points;
    for (double x = x0; x <= x1; x += 0.8)
      for (double v = -y; v <= y; v += 0.8)
        points.emplace_back(x, v, height);
    return points;
  }

  std::vector<Vector3d> points() const
  {
    std::vector<Vector3d> points = clamp();
    std::mt19937 random(2);
    std::uniform_real_distribution<double> off(-0.2, 0.2);
    for (double x = -32.0; x <= floor_end; x += 0.8)
      for (double v = -24.0; v <= 24.0; v += 0.8)
        if (x < x0 - 0.4 || x > x1 + 0.4 || std::abs(v) > y + 0.4)
          points.emplace_back(x + off(random), v + off(random), 0.0);
    return points;
  }

  double distance(double x, double v) const { return std::hypot(std::max({x0 - x, x - x1, 0.0}), std::max(std::abs(v) - y, 0.0)); }
};

/** A part of the tool above the ball: heights above the tip. */
struct Cylinder {
  double radius, bottom, top;
};

class DrivePart : public ::testing::Test {
protected:
  void write(const std::vector<Vector3d>& points)
  {
    std::ostringstream all;
    all.precision(9);
    for (const Vector3d& p : points)
      all << p.transpose() << '\n';
    writeText(folder_.path("scan.xyz"), all.str());
  }

  RunResult run(Arguments arguments)
  {
    const Arguments own{"scan.xyz", "-o", "a.csv", "--tolerance", "0.05", "--threads", "2"};
    arguments.insert(arguments.begin(), own.begin(), own.end());
    return endOf(startProgram(PCL_SPIRAL_DRIVE_PROGRAM, arguments, folder_), folder_);
  }

  pcl_spiral::ToolpathFile path() const { return pcl_spiral::readToolpath(folder_.path("a.csv")); }

  /** How deep the deepest of \p points is in the tool on the moves of the path, four places each. */
  double deepest(const std::vector<Vector3d>& points, const std::vector<Cylinder>& above) const
  {
    const auto read = path();
    double deepest = -1e300;
    for (std::size_t i = 0; i < read.tips.size(); ++i) {
      const bool same = i > 0 && read.path[i].turn == read.path[i - 1].turn;
      for (int k = same ? 1 : 4; k <= 4; ++k) {
        const std::size_t from = same ? i - 1 : i;
        const auto axisOf = [&](std::size_t j) { return read.path[j].getAxisVector3fMap().cast<double>().eval(); };
        const Vector3d axis = (axisOf(from) + (axisOf(i) - axisOf(from)) * (k / 4.0)).normalized();
        const Vector3d tip = read.tips[from] + (read.tips[i] - read.tips[from]) * (k / 4.0);
        for (const Vector3d& p : points) {
          const double h = (p - tip).dot(axis), l = (p - tip).cross(axis).norm();
          if (h <= ball)
            deepest = std::max(deepest, ball - (p - tip - ball * axis).norm());
          double below = ball;
          for (const Cylinder& c : above) {
            if (h > c.bottom && h < c.top)
              deepest = std::max(deepest, std::min(c.radius - l, l > below ? h - c.bottom : c.radius));
            below = c.radius;
          }
        }
      }
    }
    return deepest;
  }

  /** All places of the floor where \p meant holds are cut. */
  template <typename Meant>
  void expectCut(Meant meant) const
  {
    const auto read = path();
    int counted = 0;
    for (double x = -29.0; x <= 29.0; x += 2.0)
      for (double y = -21.0; y <= 21.0; y += 2.0) {
        if (!meant(x, y))
          continue;
        double nearest = 1e300;
        for (const auto& p : read.path)
          nearest = std::min(nearest, std::hypot(p.x - x, p.y - y));
        EXPECT_LT(nearest, 2.2) << x << ' ' << y;
        ++counted;
      }
    EXPECT_GT(counted, 80);
  }

  ScratchFolder folder_;
};

const Bench clamp{10.0, 18.0, 6.0, 18.0};
const Arguments leaning{"--tool-radius", "3", "--step-over", "3", "--axis", "1,0,2"}; // towards the clamp
const std::vector<Cylinder> ten_radii{{ball, ball, 33.0}};

Arguments
with(Arguments first, const Arguments& more)
{
  first.insert(first.end(), more.begin(), more.end());
  return first;
}

} // namespace

TEST_F(DrivePart, TheShankKeepsOffWhatStandsInAKeepOut)
{
  write(clamp.points());
  writeText(folder_.path("keep.txt"), "10 -6\n18 -6\n18 6\n10 6\n");
  const RunResult result = run(with(leaning, {"--keep-out", "keep.txt", "-o", "a.json"}));
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.err.find("deep in what stands in a keep-out, first at ("), std::string::npos) << result.err;
  EXPECT_LT(deepest(clamp.clamp(), ten_radii), 0.06);
  expectCut([](double x, double y) { return x < -6.0 || std::abs(y) > 11.0; });
  const auto report = nlohmann::json::parse(readText(folder_.path("a.json")));
  EXPECT_GT(report["locations"]["touching_keep_outs"].get<int>(), 20);
  const std::size_t without = path().tips.size();
  const RunResult held = run(with(leaning, {"--keep-out", "keep.txt", "--flank-length", "4", "--holder", "3,6/8,20"}));
  ASSERT_EQ(held.code, 0) << held.err;
  EXPECT_LT(deepest(clamp.clamp(), {{3.0, 3.0, 13.0}, {8.0, 13.0, 33.0}}), 0.06);
  EXPECT_LT(path().tips.size(), without) << "a chuck is wider";
  const RunResult straight = run({"--tool-radius", "3", "--step-over", "3", "--keep-out", "keep.txt"});
  ASSERT_EQ(straight.code, 0) << straight.err;
  EXPECT_EQ(straight.err.find("stands in a keep-out"), std::string::npos) << straight.err;
  expectCut([](double x, double y) { return clamp.distance(x, y) > 4.5; });
}

TEST_F(DrivePart, TheShankKeepsOffWhatWasCroppedAway)
{
  write(clamp.points());
  const RunResult result = run(with(leaning, {"--crop", "-40,9,-30,30"}));
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.err.find("deep in the scan beside what is cut"), std::string::npos) << result.err;
  EXPECT_LT(deepest(clamp.points(), ten_radii), 0.06);
  expectCut([](double x, double y) { return x < -6.0 || (x < 5.0 && std::abs(y) > 11.0); });
}

TEST_F(DrivePart, TheAxisLeansAwayWhereTheHolderWouldCollide)
{
  const Bench plate{10.0, 24.0, 8.0, 30.0, 6.0}; // beside the part, within reach of the chuck alone
  write(plate.points());
  const Arguments tool{"--tool-radius", "3", "--step-over", "3", "--flank-length", "10", "--holder", "3,10/12,30", "--largest"};
  const RunResult stuck = run(tool);
  EXPECT_EQ(stuck.code, 1);
  EXPECT_NE(stuck.err.find("segment 2 of the holder would be "), std::string::npos) << stuck.err;
  EXPECT_NE(stuck.err.find("lean the axis by --max-retilt 30"), std::string::npos) << stuck.err;
  EXPECT_FALSE(std::filesystem::exists(folder_.path("a.csv")));
  const RunResult result = run(with(tool, {"--max-retilt", "30"}));
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_LT(deepest(plate.points(), {{3.0, 3.0, 23.0}, {12.0, 23.0, 53.0}}), 0.06);
  const auto read = path();
  double largest = 0.0, turned = 0.0;
  for (std::size_t i = 1; i < read.path.size(); ++i) {
    const Vector3d a = read.path[i - 1].getAxisVector3fMap().cast<double>(), b = read.path[i].getAxisVector3fMap().cast<double>();
    if (read.path[i].turn == read.path[i - 1].turn)
      largest = std::max(largest, std::atan2(a.cross(b).norm(), a.dot(b)) * 180.0 / M_PI);
    turned = std::max(turned, std::acos(std::min(1.0, b.z())) * 180.0 / M_PI);
  }
  EXPECT_LE(largest, 3.0 + 1e-3);
  EXPECT_GT(turned, 5.0);
}

/** A tool 13 mm long beside a clamp 18 mm high: it would pass below, but what holds it would not. */
TEST_F(DrivePart, WhatIsAboveTheEndOfTheToolIsNoFreeWay)
{
  write(clamp.points());
  const Arguments tool{"--tool-radius", "3", "--step-over", "3", "--largest"}, held{"--flank-length", "4", "--holder", "3,6"};
  const RunResult refused = run(with(tool, held));
  EXPECT_EQ(refused.code, 1);
  EXPECT_NE(refused.err.find("the scan goes on above the end of the tool"), std::string::npos) << refused.err;
  EXPECT_NE(refused.err.find("13 mm above the tip: what holds the tool would be in it"), std::string::npos) << refused.err;
  EXPECT_NE(refused.err.find("(--ceiling 1000), or"), std::string::npos) << refused.err;
  EXPECT_FALSE(std::filesystem::exists(folder_.path("a.csv")));
  for (const Arguments& remedy : {with(held, {"--ceiling", "1000"}), Arguments()}) { // without a holder the tool has no end
    const RunResult lifted = run(with(tool, remedy));
    ASSERT_EQ(lifted.code, 0) << lifted.err;
    EXPECT_LT(deepest(clamp.clamp(), {{ball, ball, 1000.0}}), 0.06);
  }
  const RunResult below = run(with(tool, with(held, {"--ceiling", "13"})));
  ASSERT_EQ(below.code, 0) << below.err;
  EXPECT_NE(below.err.find("above the end of the tool, which is 13 mm long"), std::string::npos) << below.err;
  EXPECT_LT(deepest(clamp.clamp(), {{ball, ball, 13.0}}), 0.06);
}

class DriveRegions : public DrivePart {
protected:
  const Arguments tool{"--tool-radius", "4", "--step-over", "4"};
  const Arguments both{"--part-at", "-75,0,4", "--part-at", "85,10,7"};

  void refuses(const Arguments& arguments, int code, const std::string& words)
  {
    const RunResult result = run(with(tool, arguments));
    EXPECT_EQ(result.code, code) << result.err;
    EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
    EXPECT_FALSE(std::filesystem::exists(folder_.path("a.csv")));
  }
};

TEST_F(DriveRegions, AreCutOneAfterTheOtherAndTheLinkClearsTheScan)
{
  const std::vector<Vector3d> points = two_domes::twoDomes();
  write(points);
  const RunResult result = run(with(with(tool, both), {"-o", "a.ngc", "-o", "a.json"}));
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.out.find("region 2 (--part-at 85,10,7): "), std::string::npos) << result.out;
  const auto all = path();
  const auto report = nlohmann::json::parse(readText(folder_.path("a.json")));
  ASSERT_EQ(report["regions"].size(), 2U);
  std::size_t first = 0;
  for (std::size_t k = 0; k < 2; ++k) { // each is the path of a run of its own
    EXPECT_EQ(report["regions"][k]["region"], "region " + std::to_string(k + 1) + " (--part-at " + both[2 * k + 1] + ")");
    ASSERT_EQ(run(with(tool, {"--part-at", both[2 * k + 1]})).code, 0);
    const auto one = path();
    EXPECT_EQ(report["regions"][k]["locations"].get<std::size_t>(), one.tips.size());
    ASSERT_LE(first + one.tips.size(), all.tips.size());
    for (std::size_t i = 0; i < one.tips.size(); ++i)
      ASSERT_EQ(one.tips[i], all.tips[first + i]);
    first += one.tips.size();
    const two_domes::Dome& dome = k == 0 ? two_domes::left : two_domes::right;
    for (const auto& p : one.path)
      ASSERT_NEAR((p.getVector3fMap().cast<double>() - dome.centre()).norm(), two_domes::sphere, 0.1);
  }
  EXPECT_EQ(first, all.tips.size());
  const auto program =
      pcl_spiral::readProgram(folder_.path("a.ngc"), pcl_spiral::readMachine(PCL_SPIRAL_MACHINES_DIR "/xyzac.yaml"), std::nullopt).program;
  std::size_t link = 1;
  const auto length = [&](std::size_t i) { return (program.blocks[i].tip - program.blocks[i - 1].tip).norm(); };
  for (std::size_t i = 1; i < program.blocks.size(); ++i)
    if (program.blocks[i].rapid && length(i) > length(link))
      link = i;
  EXPECT_GT(length(link), 80.0) << "the way from dome to dome";
  EXPECT_GT(program.blocks[link].tip.z(), two_domes::tower_z);
  EXPECT_LT(two_domes::deepestInLinks(program, link - 1, link + 2, points), 0.03);
}

TEST_F(DriveRegions, ThatCannotBeAreRefused)
{
  write(two_domes::twoDomes());
  refuses({"--part-at", "-75,0,4", "--part-at", "-75,2,4"}, 1, "points in common, one at (");
  refuses({"--part-at", "-75,0,4", "--part-at", "85,10,200"}, 2, "region 2 (--part-at 85,10,200): ");
  writeText(folder_.path("curve.txt"), "-80 0 4\n-70 0 4\n");
  refuses({"--part-at", "-75,0,4", "--part-at", "85,10,7", "--drive", "curve", "--curve", "curve.txt"}, 2, "");
  writeText(folder_.path("west.txt"), "-120 -40\n-78 -40\n-78 40\n-120 40\n");
  refuses({"--region", "west.txt", "--part-at", "85,10,7"}, 2, "this place is in no --region");
  refuses({"--part-at", "-75,0,4", "--part-at", "85,10,7", "--raw-scan", "missing.xyz"}, 1, "missing.xyz");
  const RunResult raw = run(with(tool, {"--part-at", "-75,0,4", "--part-at", "85,10,7", "--raw-scan", "scan.xyz"}));
  EXPECT_EQ(raw.code, 0) << "each region has a part of the raw scan: " << raw.err;
  EXPECT_NE(raw.err.find("region 2 (--part-at 85,10,7): smoothing moved"), std::string::npos) << raw.err;
}

} // namespace drive_part_test
