// SPDX-License-Identifier: BSD-3-Clause
// Scans with steps whose side was not scanned: the remedies that the refusals name lead to paths clear of the exact solid.
#include <pcl_spiral/io/toolpath_reader.h>

#include "run_program.h"

#include <gtest/gtest.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <sstream>

namespace stepped_scans_test {

namespace {

using Arguments = std::vector<std::string>;
using Eigen::Vector3d;

constexpr double spacing = 0.8; // mm

class SteppedScans : public ::testing::Test {
protected:
  /** Points over a square of 60 mm, at the height \p height of x and y. */
  void write(const std::function<double(double, double)>& height)
  {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> jitter(-0.35, 0.35);
    std::normal_distribution<double> noise(0.0, 0.005);
    std::ostringstream text;
    for (int i = -37; i <= 37; ++i)
      for (int k = -37; k <= 37; ++k) {
        const double x = spacing * (i + jitter(random)), y = spacing * (k + jitter(random));
        text << x << ' ' << y << ' ' << height(x, y) + noise(random) << '\n';
      }
    writeText(folder_.path("scan.xyz"), text.str());
  }

  void writeCircle(const std::string& name, double circle_radius)
  {
    std::ostringstream circle;
    for (int k = 0; k < 60; ++k)
      circle << circle_radius * std::cos(0.10472 * k) << ' ' << circle_radius * std::sin(0.10472 * k) << '\n';
    writeText(folder_.path(name), circle.str());
  }

  RunResult run(const Arguments& more)
  {
    Arguments arguments{"scan.xyz", "-o", "a.csv", "--tool-radius", std::to_string(radius_), "--scallop", "0.1"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return endOf(startProgram(PCL_SPIRAL_TOOLPATH_PROGRAM, arguments, folder_), folder_);
  }

  /** The least of \p outside, the distance from the solid, over the ball's centres. */
  double least(const std::function<double(const Vector3d&)>& outside) const
  {
    double least = 1e300;
    for (const auto& p : pcl_spiral::readToolpath(folder_.path("a.csv")).path)
      least = std::min(least, outside(p.getVector3fMap().cast<double>() + radius_ * p.getNormalVector3fMap().cast<double>()));
    return least;
  }

  /** The largest distance of a contact from the axis. */
  double widest() const
  {
    double widest = 0.0;
    for (const auto& p : pcl_spiral::readToolpath(folder_.path("a.csv")).path)
      widest = std::max<double>(widest, std::hypot(p.x, p.y));
    return widest;
  }

  double radius_ = 4.0; ///< of the ball
  ScratchFolder folder_;
};

TEST_F(SteppedScans, TheLevelsOfABlockAreCutInRunsOfTheirOwn)
{
  constexpr double high = 4.0;
  write([](double x, double) { return x < 0.0 ? high : 0.0; });
  const RunResult whole = run({});
  EXPECT_EQ(whole.code, 1);
  EXPECT_NE(whole.err.find("2 separate parts"), std::string::npos) << whole.err;
  const RunResult both = run({"--part-at", "-15,0,4", "--part-at", "15,0,0"});
  EXPECT_EQ(both.code, 1) << "the upper level stands in the way";
  EXPECT_NE(both.err.find("give each region a run of its own"), std::string::npos) << both.err;
  const auto outside = [](const Vector3d& c) { // of the block: x < 0 under the upper level, all under the lower one
    return std::min(c.z(), std::hypot(std::max(c.x(), 0.0), std::max(c.z() - high, 0.0)));
  };
  const RunResult upper = run({"--part-at", "-15,0,4"});
  ASSERT_EQ(upper.code, 0) << upper.err;
  EXPECT_GT(least(outside), radius_ - 0.03);
  writeText(folder_.path("upper.txt"), "-31 -31\n0.5 -31\n0.5 31\n-31 31\n");
  const RunResult lower = run({"--part-at", "15,0,0", "--keep-out", "upper.txt"});
  ASSERT_EQ(lower.code, 0) << lower.err;
  EXPECT_GT(least(outside), radius_ - 0.03);
}

TEST_F(SteppedScans, APartThatIsSteepAtItsRimIsCutApartFromTheTable)
{
  constexpr double rim = 15.1;
  for (const double slope : {30.0, 45.0, 60.0, 70.0})
    for (const double step : {3.0, 5.0}) {
      SCOPED_TRACE(testing::Message() << slope << " degrees, step " << step);
      if (slope > 65.0 && step < 4.0)
        continue; // not seen
      const double sphere = rim / std::sin(slope * M_PI / 180.0), table = std::sqrt(sphere * sphere - rim * rim) - step;
      write([&](double x, double y) {
        const double r = std::hypot(x, y);
        return r < rim ? std::sqrt(sphere * sphere - r * r) : table;
      });
      const RunResult made = run({"--part-at", "0,0," + std::to_string(sphere)});
      ASSERT_EQ(made.code, 0) << made.err;
      EXPECT_NE(made.err.find("separate parts"), std::string::npos) << made.err;
      EXPECT_GT(least([&](const Vector3d& c) { return std::min(c.norm() - sphere, c.z() - table); }), radius_ - 0.03);
      EXPECT_NEAR(widest(), rim, 0.5);
    }
}

TEST_F(SteppedScans, AKeepOutElsewhereChangesNoPathOverALowPart)
{
  constexpr double sphere = 30.0, rim = 15.1; // 30 degrees steep at the rim
  writeText(folder_.path("far.txt"), "60 60\n70 60\n70 70\n60 70\n");
  for (const double step : {2.2, 2.5, 3.0}) {
    SCOPED_TRACE(step);
    const double table = std::sqrt(sphere * sphere - rim * rim) - step;
    write([&](double x, double y) {
      const double r = std::hypot(x, y);
      return r < rim ? std::sqrt(sphere * sphere - r * r) : table;
    });
    const Arguments part{"--part-at", "0,0,30"};
    ASSERT_EQ(run(part).code, 0);
    const auto alone = pcl_spiral::readToolpath(folder_.path("a.csv")).path;
    const RunResult made = run({"--part-at", "0,0,30", "--keep-out", "far.txt"});
    ASSERT_EQ(made.code, 0) << made.err;
    EXPECT_GT(least([&](const Vector3d& c) { return std::min(c.norm() - sphere, c.z() - table); }), radius_ - 0.03);
    EXPECT_NEAR(static_cast<double>(pcl_spiral::readToolpath(folder_.path("a.csv")).path.size()), static_cast<double>(alone.size()),
                0.05 * static_cast<double>(alone.size()));
    const Arguments call{"scan.xyz", "a.csv",      "--tool-radius", "4",           "--scallop", "0.1",         "--part-at",
                         "0,0,30",   "--keep-out", "far.txt",       "--max-gouge", "0.03",      "--max-uncut", "0.02"};
    const RunResult judged = endOf(startProgram(PCL_SPIRAL_VERIFY_PROGRAM, call, folder_), folder_);
    EXPECT_EQ(judged.code, 0) << judged.out << judged.err;
  }
}

TEST_F(SteppedScans, APartWhoseRimRunsIntoItsSideIsCutWhenCropped)
{
  constexpr double rim = 15.1;
  int named = 0; // refusals for a handle or for turns that cross
  for (const double slope : {80.0, 88.0})
    for (const double step : {2.0, 2.5, 3.0, 4.0}) {
      SCOPED_TRACE(testing::Message() << slope << " degrees, step " << step);
      const double sphere = rim / std::sin(slope * M_PI / 180.0), table = std::sqrt(sphere * sphere - rim * rim) - step;
      write([&](double x, double y) {
        const double r = std::hypot(x, y);
        return r < rim ? std::sqrt(sphere * sphere - r * r) : table;
      });
      const RunResult whole = run({"--part-at", "0,0," + std::to_string(sphere)});
      const bool is_named = whole.err.find("such as the table below it, crop it to the part (--crop)") != std::string::npos;
      named += is_named && whole.code == 1 ? 1 : 0;
      writeCircle("crop.txt", rim - 0.8);
      const RunResult made = run({"--crop", "crop.txt"});
      ASSERT_EQ(made.code, 0) << made.err;
      EXPECT_GT(least([sphere](const Vector3d& c) { return c.norm() - sphere; }), radius_ - 0.03);
      EXPECT_NEAR(widest(), rim - 0.8, 0.5);
    }
  EXPECT_GT(named, 1);
}

TEST_F(SteppedScans, ATableAllRoundTheRimIsLeftOutByACropInsideIt)
{
  constexpr double sphere = 40.0, rim = 20.1, step = 2.4; // 30 degrees steep at the rim
  const double table = std::sqrt(sphere * sphere - rim * rim) - step;
  radius_ = 20.0; // at the rim it is 0.3 mm deep in the table
  write([table](double x, double y) {
    const double r = std::hypot(x, y);
    return r < rim ? std::sqrt(sphere * sphere - r * r) : table;
  });
  const RunResult refused = run({"--part-at", "0,0,40"});
  EXPECT_EQ(refused.code, 1);
  EXPECT_NE(refused.err.find("crop the scan inside the rim of the part (--crop)"), std::string::npos) << refused.err;
  writeCircle("crop.txt", 17.0);
  const RunResult made = run({"--crop", "crop.txt"});
  ASSERT_EQ(made.code, 0) << made.err;
  EXPECT_GT(least([table](const Vector3d& c) { return std::min(c.norm() - sphere, c.z() - table); }), radius_ - 0.03);
}

} // namespace

} // namespace stepped_scans_test
