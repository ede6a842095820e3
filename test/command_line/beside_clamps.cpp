// SPDX-License-Identifier: BSD-3-Clause
// Clamps beside a cap and near its rim, known exactly: refusals name what stands in the way and its extent, and a polygon drawn by it
// helps; narrow strips beside a keep-out are left out.
#include <pcl_spiral/io/toolpath_reader.h>

#include "run_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <random>
#include <regex>
#include <sstream>

namespace {

using Arguments = std::vector<std::string>;
using Eigen::AlignedBox2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double ball = 100.0, rim = 40.0, radius = 4.0, scallop = 0.05; // mm

Vector3d
onCap(double x, double y)
{
  return {x, y, std::sqrt(ball * ball - x * x - y * y) - ball};
}

double
distance(const AlignedBox2d& box, const Vector2d& p)
{
  return std::sqrt(box.squaredExteriorDistance(p));
}

class BesideClamps : public ::testing::Test {
protected:
  /** Scan of the cap and the flat tops of \p clamps, which hide the cap, at the height \p top. */
  void write(const std::vector<AlignedBox2d>& clamps, double top)
  {
    std::mt19937 random(8);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::normal_distribution<double> noise(0.0, 0.003);
    std::ostringstream all;
    all << std::setprecision(9);
    for (int i = 0; i < 9000; ++i) {
      const double r = rim * std::sqrt(unit(random)), angle = 2.0 * M_PI * unit(random);
      const Vector2d p(r * std::cos(angle), r * std::sin(angle));
      if (std::none_of(clamps.begin(), clamps.end(), [&](const AlignedBox2d& clamp) { return clamp.contains(p); }))
        all << (onCap(p.x(), p.y()) + Vector3d(0.0, 0.0, noise(random))).transpose() << '\n';
    }
    for (const AlignedBox2d& clamp : clamps)
      for (double x = clamp.min().x(); x <= clamp.max().x(); x += 0.8)
        for (double y = clamp.min().y(); y <= clamp.max().y(); y += 0.8)
          all << x << ' ' << y << ' ' << top << '\n';
    writeText(folder_.path("scan.xyz"), all.str());
  }

  void writePolygon(const std::string& name, const AlignedBox2d& box) const
  {
    std::ostringstream text;
    for (const auto corner : {AlignedBox2d::BottomLeft, AlignedBox2d::BottomRight, AlignedBox2d::TopRight, AlignedBox2d::TopLeft})
      text << box.corner(corner).transpose() << '\n';
    writeText(folder_.path(name), text.str());
  }

  RunResult run(Arguments arguments)
  {
    const Arguments own{"scan.xyz", "-o", "a.csv", "--tool-radius", "4", "--scallop", "0.05", "--part-at", "-20,0,-2"};
    arguments.insert(arguments.begin(), own.begin(), own.end());
    return endOf(startProgram(PCL_SPIRAL_TOOLPATH_PROGRAM, arguments, folder_), folder_);
  }

  /** The path stays clear of the clamps, and cuts the cap but for a band at its rim and within \p around of a clamp. */
  void expectCapCut(const std::vector<AlignedBox2d>& clamps, double around) const
  {
    std::vector<Vector3d> centres;
    for (const auto& p : pcl_spiral::readToolpath(folder_.path("a.csv")).path) {
      centres.push_back(p.getVector3fMap().cast<double>() + radius * p.getNormalVector3fMap().cast<double>());
      for (const AlignedBox2d& clamp : clamps)
        ASSERT_GT(distance(clamp, centres.back().head<2>()), radius - 0.02) << centres.back().transpose();
    }
    int counted = 0;
    for (double x = -rim; x <= rim; x += 2.3)
      for (double y = -rim; y <= rim; y += 2.3) {
        const Vector2d p(x, y);
        if (p.norm() > rim - 4.5 ||
            std::any_of(clamps.begin(), clamps.end(), [&](const AlignedBox2d& clamp) { return distance(clamp, p) < around; }))
          continue;
        ++counted;
        double least = std::numeric_limits<double>::max();
        for (const Vector3d& c : centres)
          least = std::min(least, (c - onCap(x, y)).norm());
        EXPECT_LT(least - radius, 0.3) << "not cut: " << p.transpose(); // from path points: up to a step between them
      }
    EXPECT_GT(counted, 300);
  }

  /** The extents "from (..) to (..)" of a message, seen from above, in its order. */
  static std::vector<AlignedBox2d> extents(const std::string& message)
  {
    const std::string number = "(-?[0-9.e+]+)", place = "\\(" + number + ", " + number + ", " + number + "\\)";
    const std::regex extent("from " + place + " to " + place);
    std::vector<AlignedBox2d> found;
    for (std::sregex_iterator i(message.begin(), message.end(), extent), end; i != end; ++i)
      found.emplace_back(Vector2d(std::stod((*i)[1]), std::stod((*i)[2])), Vector2d(std::stod((*i)[4]), std::stod((*i)[5])));
    return found;
  }

  ScratchFolder folder_;
};

} // namespace

TEST_F(BesideClamps, ARefusalNamesTheExtentOfEveryClampInTheWayAndPolygonsByItHelp)
{
  const std::vector<AlignedBox2d> clamps{{Vector2d(42.0, -9.0), Vector2d(60.0, 7.0)}, {Vector2d(-12.0, 42.0), Vector2d(4.0, 55.0)}};
  write(clamps, 14.0);
  const RunResult refused = run({});
  ASSERT_EQ(refused.code, 1) << refused.err;
  EXPECT_NE(refused.err.find("2 things stand in the way"), std::string::npos) << refused.err;
  const std::vector<AlignedBox2d> named = extents(refused.err);
  ASSERT_EQ(named.size(), 2U) << refused.err;
  Arguments remedy;
  for (const AlignedBox2d& box : named) {
    const auto same = [&](const AlignedBox2d& clamp) {
      return box.contains(clamp.min()) && (clamp.min() - box.min()).norm() < 2.5 && (clamp.max() - box.max()).norm() < 1.2;
    };
    EXPECT_TRUE(std::any_of(clamps.begin(), clamps.end(), same)) << refused.err;
    const std::string file = "keep_" + std::to_string(remedy.size()) + ".txt";
    writePolygon(file, box);
    remedy.insert(remedy.end(), {"--keep-out", file});
  }
  remedy.insert(remedy.end(), {"--tilt", "0"}); // the other half of the remedy: a tilted shank meets them
  const RunResult result = run(remedy);
  ASSERT_EQ(result.code, 0) << result.err;
  expectCapCut(clamps, 16.0);
}

TEST_F(BesideClamps, AllSmallPartsAreListedOrCounted)
{
  std::vector<AlignedBox2d> clamps{{Vector2d(60.0, -40.0), Vector2d(130.0, 40.0)}}; // too large for a cluster
  for (int i = 0; i < 2; ++i)
    clamps.emplace_back(Vector2d(-70.0 + 40.0 * i, 60.0), Vector2d(-62.0 + 40.0 * i, 68.0));
  write(clamps, 14.0);
  const Arguments call{"scan.xyz", "-o", "a.csv", "--tool-radius", "4", "--scallop", "0.05"};
  const RunResult refused = endOf(startProgram(PCL_SPIRAL_TOOLPATH_PROGRAM, call, folder_), folder_);
  EXPECT_EQ(refused.code, 1);
  EXPECT_NE(refused.err.find("4 separate parts"), std::string::npos) << refused.err;
  const std::regex part("mm2 at \\(");
  EXPECT_EQ(std::distance(std::sregex_iterator(refused.err.begin(), refused.err.end(), part), std::sregex_iterator()), 4) << refused.err;
}
