// SPDX-License-Identifier: BSD-3-Clause
// A thing stands on a cap: every program refuses, rides over it or leaves it out, as asked for.
#include <pcl_spiral/io/toolpath_reader.h>

#include "run_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <sstream>

namespace clusters_test {

namespace {

using Arguments = std::vector<std::string>;
using Eigen::Vector3d;

constexpr double sphere = 100.0, rim = 25.0, radius = 4.0, height = 4.5; // mm

class Clusters : public ::testing::Test {
protected:
  Clusters()
  {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> jitter(-0.3, 0.3);
    std::normal_distribution<double> noise(0.0, 0.003);
    std::ostringstream all;
    for (double i = -rim; i <= rim; ++i)
      for (double j = -rim; j <= rim; ++j) {
        const double x = i + jitter(random), y = j + jitter(random);
        if (x * x + y * y < rim * rim)
          all << x << ' ' << y << ' ' << std::sqrt(sphere * sphere - x * x - y * y) - sphere + noise(random) << '\n';
      }
    for (int i = 0; i < 9; ++i) {
      thing_.emplace_back(6.0 + i % 3 + 0.3 * jitter(random), -4.0 + i / 3 + 0.3 * jitter(random), height);
      all << thing_.back().transpose() << '\n';
    }
    writeText(folder_.path("scan.xyz"), all.str());
  }

  RunResult run(const char* program, Arguments own, const Arguments& more)
  {
    own.insert(own.begin(), "scan.xyz");
    own.insert(own.end(), {"--tool-radius", "4"});
    own.insert(own.end(), more.begin(), more.end());
    return endOf(startProgram(program, own, folder_), folder_);
  }

  RunResult plan(const Arguments& more)
  {
    return run(PCL_SPIRAL_TOOLPATH_PROGRAM, {"-o", "a.csv", "-o", "a.json", "--scallop", "0.05"}, more);
  }
  RunResult drive(const Arguments& more) { return run(PCL_SPIRAL_DRIVE_PROGRAM, {"-o", "a.csv", "--step-over", "1"}, more); }
  RunResult verify(const Arguments& more) { return run(PCL_SPIRAL_VERIFY_PROGRAM, {"a.csv", "--scallop", "0.05", "-o", "v.json"}, more); }

  /** How deep a point of the thing is in the ball on its way. */
  double deepest() const
  {
    const auto path = pcl_spiral::readToolpath(folder_.path("a.csv")).path;
    const auto centre = [](const auto& p) -> Vector3d {
      return p.getVector3fMap().template cast<double>() + radius * p.getNormalVector3fMap().template cast<double>();
    };
    double depth = -1e300;
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
      for (int k = 0; k < 20 && path[i + 1].turn - path[i].turn < 0.9f; ++k) {
        const Vector3d c = centre(path[i]) + (centre(path[i + 1]) - centre(path[i])) * (k / 20.0);
        for (const Vector3d& p : thing_)
          depth = std::max(depth, radius - (c - p).norm());
      }
    return depth;
  }

  /** How deep a point of the thing is in the shank, 10 radii long, whose axis turns evenly on each move. */
  double deepestInShank() const
  {
    const auto path = pcl_spiral::readToolpath(folder_.path("a.csv")).path;
    double depth = -1e300;
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
      for (int k = 0; k < 20 && path[i + 1].turn - path[i].turn < 0.9f; ++k) {
        const auto between = [&](const Vector3d& a, const Vector3d& b) -> Vector3d { return a + (b - a) * (k / 20.0); };
        const auto centre = [&](const auto& p) -> Vector3d {
          return p.getVector3fMap().template cast<double>() + radius * p.getNormalVector3fMap().template cast<double>();
        };
        const auto axis = [](const auto& p) -> Vector3d { return p.getAxisVector3fMap().template cast<double>(); };
        const Vector3d c = between(centre(path[i]), centre(path[i + 1])), a = between(axis(path[i]), axis(path[i + 1])).normalized();
        for (const Vector3d& p : thing_)
          if (const double along = (p - c).dot(a); along > 0.0 && along < 10.0 * radius)
            depth = std::max(depth, radius - (p - c - along * a).norm());
      }
    return depth;
  }

  static bool has(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

  std::vector<Vector3d> thing_;
  ScratchFolder folder_;
};

} // namespace

TEST_F(Clusters, TheRefusalNamesTheThingAndItsRemediesWork)
{
  const RunResult refused = plan({});
  EXPECT_EQ(refused.code, 1);
  for (const char* words :
       {"9 points at (", " mm high, from (", "ride over it (--clusters ride)", "(--clusters leave-out)", "(--keep-out)"})
    EXPECT_TRUE(has(refused.err, words)) << words << ": " << refused.err;
  const RunResult ridden = plan({"--clusters", "ride", "--tilt", "-25", "--verify", "--max-gouge", "0.02"});
  ASSERT_EQ(ridden.code, 0) << ridden.err;
  EXPECT_LE(deepest(), 1e-4);
  EXPECT_LE(deepestInShank(), 1e-3);
  EXPECT_TRUE(has(ridden.err, "the tool leans less than the set tilt")) << ridden.err;
  EXPECT_TRUE(has(ridden.out, "under cluster")) << ridden.out;
  EXPECT_TRUE(has(readText(folder_.path("a.json")), "\"under_cluster\": true"));
  ASSERT_EQ(plan({"--clusters", "leave-out"}).code, 0);
  EXPECT_GT(deepest(), 3.0);
  Vector3d low, high;
  const std::string extent = refused.err.substr(refused.err.find("high, from ("));
  ASSERT_EQ(std::sscanf(extent.c_str(), "high, from (%lf, %lf, %lf) to (%lf, %lf, %lf)", &low.x(), &low.y(), &low.z(), &high.x(), &high.y(),
                        &high.z()),
            6)
      << extent;
  for (const Vector3d& p : thing_)
    EXPECT_TRUE(((p - low).array() > -1e-3).all() && ((high - p).array() > -1e-3).all()) << p.transpose();
  std::ostringstream polygon;
  polygon << low.x() - 0.5 << ' ' << low.y() - 0.5 << '\n' << high.x() + 0.5 << ' ' << low.y() - 0.5 << '\n';
  polygon << high.x() + 0.5 << ' ' << high.y() + 0.5 << '\n' << low.x() - 0.5 << ' ' << high.y() + 0.5 << '\n';
  writeText(folder_.path("keep.txt"), polygon.str());
  const RunResult kept_out = plan({"--keep-out", "keep.txt"});
  ASSERT_EQ(kept_out.code, 0) << kept_out.err;
  EXPECT_LE(deepest(), 1e-4);
}

TEST_F(Clusters, VerifyNamesTheThingAndFindsAPathThroughIt)
{
  ASSERT_EQ(plan({"--clusters", "ride"}).code, 0);
  const RunResult good = verify({"--max-gouge", "0.02", "--max-uncut", "0"});
  EXPECT_EQ(good.code, 0) << good.err << good.out;
  EXPECT_TRUE(has(readText(folder_.path("v.json")), "9 points at (")) << "the report names it";
  ASSERT_EQ(plan({"--clusters", "leave-out"}).code, 0);
  const RunResult through = verify({});
  EXPECT_EQ(through.code, 1);
  EXPECT_TRUE(has(through.err + through.out, "where a cluster of points stands on the part")) << through.err << through.out;
  EXPECT_EQ(verify({"--clusters", "leave-out"}).code, 0);
  EXPECT_EQ(verify({"--clusters", "refuse"}).code, 2);
}

TEST_F(Clusters, ADriveRefusesRidesOrLeavesOut)
{
  const RunResult refused = drive({});
  EXPECT_EQ(refused.code, 1);
  EXPECT_TRUE(has(refused.err, "9 points at (") && has(refused.err, "ride over it (--clusters ride)")) << refused.err;
  const RunResult ridden = drive({"--clusters", "ride"});
  ASSERT_EQ(ridden.code, 0) << ridden.err;
  EXPECT_TRUE(has(ridden.err, "the cutter rides over what is there")) << ridden.err;
  EXPECT_LT(deepest(), 0.02) << "the tolerance of a move is 0.01";
  ASSERT_EQ(drive({"--clusters", "leave-out"}).code, 0);
  EXPECT_GT(deepest(), 3.0);
}

} // namespace clusters_test
