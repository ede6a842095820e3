// SPDX-License-Identifier: BSD-3-Clause
// Clamps beside a cap and near its rim, known exactly: refusals name what stands in the way and its extent, and a polygon drawn by it
// helps; a strip beside a keep-out is left uncut only where no path is found with it, and is named.
#include <pcl_spiral/io/toolpath_reader.h>

#include "run_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <random>
#include <regex>
#include <sstream>

namespace beside_clamps_test {

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
  /** Scan of the cap where \p is_part holds, and of \p more points. */
  template <typename IsPart>
  void writeCap(IsPart is_part, const std::string& more = "")
  {
    std::mt19937 random(8);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::normal_distribution<double> noise(0.0, 0.003);
    std::ostringstream all;
    all << std::setprecision(9);
    for (int i = 0; i < 9000; ++i) {
      const double r = rim * std::sqrt(unit(random)), angle = 2.0 * M_PI * unit(random);
      const Vector2d p(r * std::cos(angle), r * std::sin(angle));
      if (is_part(p))
        all << (onCap(p.x(), p.y()) + Vector3d(0.0, 0.0, noise(random))).transpose() << '\n';
    }
    writeText(folder_.path("scan.xyz"), all.str() + more);
  }

  /** Scan of the cap and the flat tops of \p clamps, which hide the cap, at the height \p top. */
  void write(const std::vector<AlignedBox2d>& clamps, double top)
  {
    std::ostringstream tops;
    for (const AlignedBox2d& clamp : clamps)
      for (double x = clamp.min().x(); x <= clamp.max().x(); x += 0.8)
        for (double y = clamp.min().y(); y <= clamp.max().y(); y += 0.8)
          tops << x << ' ' << y << ' ' << top << '\n';
    const auto is_part = [&](const Vector2d& p) {
      return std::none_of(clamps.begin(), clamps.end(), [&](const AlignedBox2d& clamp) { return clamp.contains(p); });
    };
    writeCap(is_part, tops.str());
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

  /** Exact places of the cap at least 4.5 mm from its rim, where neither the ball nor its leaning shank comes nearer than \p band to
   *  \p clamp, which is \p top high, and which the path in a.csv leaves uncut. */
  std::vector<Vector3d> uncutPlaces(const AlignedBox2d& clamp, double top, double band) const
  {
    std::vector<Vector3d> centres, uncut;
    for (const auto& p : pcl_spiral::readToolpath(folder_.path("a.csv")).path)
      centres.push_back(p.getVector3fMap().cast<double>() + radius * p.getNormalVector3fMap().cast<double>());
    for (double x = -rim; x <= rim; x += 1.1)
      for (double y = -rim; y <= rim; y += 1.1) {
        const Vector3d p = onCap(x, y), normal = (p + Vector3d(0.0, 0.0, ball)) / ball;
        if (std::hypot(x, y) > rim - 4.5 || leaningClearance(clamp, top, p + radius * normal, normal) < band)
          continue;
        double least = std::numeric_limits<double>::max();
        for (const Vector3d& c : centres)
          least = std::min(least, (c - p).norm());
        if (least - radius > 0.3) // from path points: up to a step between them
          uncut.push_back(p);
      }
    return uncut;
  }

  /** Distance from the clamp of the ball at \p centre and of its shank, ten radii long, leaning from \p normal by up to 17 degrees. */
  static double leaningClearance(const AlignedBox2d& clamp, double top, const Vector3d& centre, const Vector3d& normal)
  {
    const double lean = 17.0 * M_PI / 180.0;
    const Vector3d across = normal.unitOrthogonal(), other = normal.cross(across);
    double least = distance(clamp, centre.head<2>()) - radius;
    for (int k = 0; k < 24; ++k) {
      const double angle = M_PI * k / 12.0;
      const Vector3d axis = std::cos(lean) * normal + std::sin(lean) * (std::cos(angle) * across + std::sin(angle) * other);
      for (double s = 0.0; s <= 10.0 * radius; s += 0.5) {
        const Vector3d place = centre + s * axis;
        least = std::min(least, std::hypot(distance(clamp, place.head<2>()), std::max(place.z() - top, 0.0)) - radius);
      }
    }
    return least;
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
  const RunResult refused = run({"--remedy-tries", "0"}); // the change that helps would name them again
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

TEST_F(BesideClamps, LessTiltIsARemedyOnlyWhereItHelps)
{
  const AlignedBox2d on_part(Vector2d(20.0, -4.0), Vector2d(28.0, 4.0)), beside(Vector2d(57.0, -9.0), Vector2d(72.0, 7.0));
  constexpr double top = 14.0;
  write({on_part}, 12.0);
  const RunResult in_the_way = run({});
  EXPECT_EQ(in_the_way.code, 1);
  EXPECT_NE(in_the_way.err.find("stands in the way"), std::string::npos) << in_the_way.err;
  EXPECT_EQ(in_the_way.err.find("--tilt"), std::string::npos) << "an upright tool hits it, too: " << in_the_way.err;
  write({beside}, top);
  const RunResult leaning = run({});
  EXPECT_EQ(leaning.code, 1);
  EXPECT_NE(leaning.err.find("tilt the tool less (--tilt)"), std::string::npos) << leaning.err;
  const RunResult straight = run({"--tilt", "0"});
  ASSERT_EQ(straight.code, 0) << straight.err;
  for (const auto& p : pcl_spiral::readToolpath(folder_.path("a.csv")).path) {
    const Vector3d centre = p.getVector3fMap().cast<double>() + radius * p.getNormalVector3fMap().cast<double>();
    for (double s = 0.0; s <= 10.0 * radius; s += 0.5) {
      const Vector3d place = centre + s * p.getAxisVector3fMap().cast<double>();
      ASSERT_GT(std::hypot(distance(beside, place.head<2>()), std::max(place.z() - top, 0.0)), radius) << centre.transpose();
    }
  }
}

TEST_F(BesideClamps, NoTiltIsNamedToAFixedAxis)
{
  const AlignedBox2d beside(Vector2d(57.0, -9.0), Vector2d(72.0, 7.0));
  write({beside}, 14.0);
  writePolygon("keep.txt", beside);
  const RunResult into = run({"--axis", "0.8,0,1"});
  EXPECT_EQ(into.code, 1);
  EXPECT_NE(into.err.find("stands in the way"), std::string::npos) << into.err;
  EXPECT_EQ(into.err.find("--tilt"), std::string::npos) << "the axis keeps it: " << into.err;
  const RunResult kept_out = run({"--axis", "1,0,1", "--keep-out", "keep.txt"});
  EXPECT_EQ(kept_out.code, 1);
  EXPECT_NE(kept_out.err.find("into what stands in a keep-out"), std::string::npos) << kept_out.err;
  EXPECT_EQ(kept_out.err.find("--tilt"), std::string::npos) << "the axis keeps it: " << kept_out.err;
}

TEST_F(BesideClamps, AStripIsLeftUncutOnlyWhereNoPathIsFoundWithItAndIsNamed)
{
  constexpr double top = 12.0;
  const auto cut = [&](double x, AlignedBox2d& clamp) {
    clamp = AlignedBox2d(Vector2d(x - 4.0, -4.0), Vector2d(x + 4.0, 4.0));
    write({clamp}, top);
    writePolygon("keep.txt", {clamp.min() - Vector2d::Constant(0.5), clamp.max() + Vector2d::Constant(0.5)});
    return run({"--keep-out", "keep.txt", "-o", "a.json"});
  };
  AlignedBox2d clamp;
  const RunResult wide = cut(28.0, clamp); // a path is found: all is cut
  ASSERT_EQ(wide.code, 0) << wide.err;
  EXPECT_EQ(wide.err.find("a strip between"), std::string::npos) << wide.err;
  EXPECT_EQ(uncutPlaces(clamp, top, 3.0).size(), 0U);
  std::size_t named = 0;
  for (const double x : {29.5, 30.0, 31.0}) {
    const RunResult narrow = cut(x, clamp);
    ASSERT_EQ(narrow.code, 0) << narrow.err;
    const std::string number = "(-?[0-9.e+]+)";
    const std::regex strip("is not cut: " + number + " mm2 at \\(" + number + ", " + number + ", [^)]*\\), narrower than " + number);
    double area = 0.0;
    std::vector<Vector2d> places;
    for (std::sregex_iterator i(narrow.err.begin(), narrow.err.end(), strip), end; i != end; ++i) {
      area += std::stod((*i)[1]);
      places.emplace_back(std::stod((*i)[2]), std::stod((*i)[3]));
      EXPECT_GT(places.back().x(), clamp.max().x() + radius) << "beyond the clamp: " << narrow.err;
      EXPECT_LT(places.back().norm(), rim) << narrow.err;
      EXPECT_LT(std::stod((*i)[4]), 3.9) << "five spacings: " << narrow.err;
    }
    named += places.size();
    EXPECT_LT(area, 4.0 * 20.0) << narrow.err;
    EXPECT_EQ(readText(folder_.path("a.json")).find("a strip between a keep-out and the rim is not cut") == std::string::npos,
              places.empty());
    const nlohmann::json report = nlohmann::json::parse(readText(folder_.path("a.json")));
    if (!places.empty()) { // the first try is the whole part, and says why another one was made
      ASSERT_TRUE(report.contains("tries"));
      ASSERT_GE(report["tries"].size(), 2U);
      EXPECT_EQ(report["tries"][0]["strip_width"], 0.0);
      EXPECT_TRUE(report["tries"][0]["refusal"].is_string());
    }
    for (const Vector3d& p : uncutPlaces(clamp, top, 3.0))
      EXPECT_TRUE(std::any_of(places.begin(), places.end(), [&](const Vector2d& q) { return (q - p.head<2>()).norm() < 0.5 * area; }))
          << "not cut and not named: " << p.transpose() << '\n'
          << narrow.err;
    for (const auto& p : pcl_spiral::readToolpath(folder_.path("a.csv")).path) {
      const Vector3d centre = p.getVector3fMap().cast<double>() + radius * p.getNormalVector3fMap().cast<double>();
      ASSERT_GT(distance(clamp, centre.head<2>()), radius - 0.02) << centre.transpose();
    }
  }
  EXPECT_GT(named, 0U) << "no case has a strip that is left uncut";
}

TEST_F(BesideClamps, AStripBetweenAHoleAndTheRimIsNamedAndAPolygonByItsExtentOrTheRadialMethodHelps)
{
  constexpr double hole = 8.0;
  for (const double width : {1.0, 2.0}) {
    const Vector2d middle(rim - width - hole, 0.0);
    writeCap([&](const Vector2d& p) { return (p - middle).norm() > hole; });
    const Arguments call{"scan.xyz", "-o", "a.csv", "--tool-radius", "4", "--scallop", "0.05", "--method", "constant-scallop"};
    const RunResult refused = endOf(startProgram(PCL_SPIRAL_TOOLPATH_PROGRAM, call, folder_), folder_);
    ASSERT_EQ(refused.code, 1) << refused.err;
    std::smatch found;
    ASSERT_TRUE(std::regex_search(refused.err, found, std::regex("only ([0-9.]+) mm wide at \\(([-0-9.]+), ([-0-9.]+),"))) << refused.err;
    EXPECT_NEAR(std::stod(found[1]), width, 0.4) << "half a spacing";
    EXPECT_NEAR(std::stod(found[2]), rim - 0.5 * width, 0.4);
    EXPECT_NEAR(std::stod(found[3]), 0.0, 3.0);
    const std::vector<AlignedBox2d> named = extents(refused.err);
    ASSERT_EQ(named.size(), 1U) << refused.err;
    EXPECT_TRUE(named.front().contains(Vector2d(rim - 0.5 * width, 0.0))) << refused.err;
    EXPECT_GT(named.front().min().x(), rim - 8.0) << refused.err;
    Arguments remedy = call;
    remedy.insert(remedy.end(), {"--keep-out", "keep.txt"});
    writePolygon("keep.txt", {named.front().min(), named.front().max()});
    const RunResult result = endOf(startProgram(PCL_SPIRAL_TOOLPATH_PROGRAM, remedy, folder_), folder_);
    EXPECT_EQ(result.code, 0) << result.err;
    Arguments other = call;
    other.back() = "radial"; // the other remedy
    const RunResult radial = endOf(startProgram(PCL_SPIRAL_TOOLPATH_PROGRAM, other, folder_), folder_);
    EXPECT_EQ(radial.code, 0) << radial.err;
  }
}

TEST_F(BesideClamps, SinglePointsAboveTheSurfaceAreNoThings)
{
  const AlignedBox2d clamp(Vector2d(8.0, -4.0), Vector2d(16.0, 4.0));
  writeCap([&](const Vector2d& p) { return !clamp.contains(p); }, "18.5 0.3 6\n3.2 5.1 11\n"); // no clamp stands in the keep-out
  writePolygon("keep.txt", clamp);
  const RunResult done = run({"--keep-out", "keep.txt"});
  ASSERT_EQ(done.code, 0) << done.err;
  EXPECT_NE(done.err.find("single points off the surface near keep-outs were left out"), std::string::npos) << done.err;
  expectCapCut({clamp}, 2.0 * radius + 2.0);
}

TEST_F(BesideClamps, SinglePointsBesideACropAreNoThingsButAPinIs)
{
  const Arguments crop{"--crop", "-41,20,-41,41"};
  const auto all = [](const Vector2d&) { return true; };
  const auto judged = [&](const char* echo, int code) {
    Arguments call{"scan.xyz", "a.csv", "--tool-radius", "4", "--crop", "-41,20,-41,41"};
    const RunResult result = endOf(startProgram(PCL_SPIRAL_VERIFY_PROGRAM, call, folder_), folder_);
    EXPECT_EQ(result.code, code) << result.err;
    EXPECT_NE((result.out + result.err).find(echo), std::string::npos) << result.out << result.err;
  };
  std::ostringstream echo, pin;
  echo << (onCap(22.0, 0.3) + Vector3d(0.0, 0.0, 3.0)).transpose() << '\n';
  writeCap(all, echo.str());
  const RunResult done = run(crop);
  ASSERT_EQ(done.code, 0) << done.err;
  EXPECT_NE(done.err.find("only single points off the surface are there"), std::string::npos) << done.err;
  expectCapCut({AlignedBox2d(Vector2d(26.0, -41.0), Vector2d(41.0, 41.0))}, 10.5);
  judged("only single points off the surface are there", 0);
  for (int i = 0; i < 9; ++i)
    pin << (onCap(22.0, 0.3) + Vector3d(0.5 * (i % 3), 0.5 * (i / 3), 3.0)).transpose() << '\n';
  writeCap(all, pin.str());
  const RunResult refused = run(crop);
  EXPECT_EQ(refused.code, 1);
  EXPECT_NE(refused.err.find("1 thing stands in the way"), std::string::npos) << refused.err;
  judged("beside what is cut", 1); // the path of the scan without a pin
}

/** Between a clamp and the rim few points are left: neither the judge nor the path takes them as part of the table below. */
TEST_F(BesideClamps, WhatIsLeftAtTheRimJoinsNoTable)
{
  const double table = onCap(rim, 0.0).z() - 15.0;
  std::ostringstream below;
  for (double x = -60.0; x <= 60.0; x += 0.8)
    for (double y = -60.0; y <= 60.0; y += 0.8)
      if (std::hypot(x, y) > rim)
        below << x << ' ' << y << ' ' << table << '\n';
  for (const double end : {32.0, 33.0, 34.0}) {
    SCOPED_TRACE(end);
    const AlignedBox2d clamp(Vector2d(end - 10.0, -7.0), Vector2d(end, 7.0));
    constexpr double top = 2.0;
    std::ostringstream tops;
    for (double x = clamp.min().x(); x <= end; x += 0.8)
      for (double y = -7.0; y <= 7.0; y += 0.8)
        tops << x << ' ' << y << ' ' << top << '\n';
    writeCap([&](const Vector2d& p) { return !clamp.contains(p); }, tops.str() + below.str());
    writePolygon("clamp.txt", AlignedBox2d(clamp.min() - Vector2d::Constant(0.5), clamp.max() + Vector2d::Constant(0.5)));
    const RunResult made = run({"--keep-out", "clamp.txt"});
    ASSERT_EQ(made.code, 0) << made.err;
    for (const Vector3d& p : uncutPlaces(clamp, top, 2.5))
      EXPECT_GT(p.x(), end) << "not cut, and not between clamp and rim: " << p.transpose();
    const Arguments call{"scan.xyz", "a.csv",     "--tool-radius", "4",          "--scallop",
                         "0.05",     "--part-at", "-20,0,-2",      "--keep-out", "clamp.txt"};
    const RunResult judged = endOf(startProgram(PCL_SPIRAL_VERIFY_PROGRAM, call, folder_), folder_);
    const std::size_t uncut = judged.out.find("uncut ");
    ASSERT_NE(uncut, std::string::npos) << judged.out;
    EXPECT_LT(std::stod(judged.out.substr(uncut + 6)), 8.0) << judged.out;
  }
}

TEST_F(BesideClamps, TheLargestPartIsChosenBeforePlacesBesideAKeepOutAreDropped)
{
  const double table = onCap(rim, 0.0).z() - 15.0;
  const AlignedBox2d clamp(Vector2d(23.0, -7.0), Vector2d(33.0, 7.0));
  std::ostringstream others;
  for (double x = clamp.min().x(); x <= clamp.max().x(); x += 0.8)
    for (double y = -7.0; y <= 7.0; y += 0.8)
      others << x << ' ' << y << " 2\n";
  for (double x = 20.0; x <= 60.0; x += 0.8)
    for (double y = -30.0; y <= 30.0; y += 0.8)
      if (std::hypot(x, y) > rim)
        others << x << ' ' << y << ' ' << table << '\n';
  writeCap([&](const Vector2d& p) { return !clamp.contains(p); }, others.str());
  writePolygon("clamp.txt", AlignedBox2d(clamp.min() - Vector2d::Constant(0.5), clamp.max() + Vector2d::Constant(0.5)));
  const RunResult placed = run({"--keep-out", "clamp.txt"});
  ASSERT_EQ(placed.code, 0) << placed.err;
  const auto path = pcl_spiral::readToolpath(folder_.path("a.csv")).path;
  const Arguments call{"scan.xyz", "-o", "b.csv", "--tool-radius", "4", "--scallop", "0.05", "--largest", "--keep-out", "clamp.txt"};
  const RunResult largest = endOf(startProgram(PCL_SPIRAL_TOOLPATH_PROGRAM, call, folder_), folder_);
  ASSERT_EQ(largest.code, 0) << largest.err;
  EXPECT_NE(largest.err.find("kept only the largest of"), std::string::npos) << largest.err;
  const auto same = pcl_spiral::readToolpath(folder_.path("b.csv")).path;
  ASSERT_EQ(same.size(), path.size());
  for (std::size_t i = 0; i < path.size(); ++i)
    ASSERT_EQ(same[i].getVector3fMap(), path[i].getVector3fMap()) << i;
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

} // namespace beside_clamps_test
