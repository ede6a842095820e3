// SPDX-License-Identifier: BSD-3-Clause
// Messages for scans and settings that are impossible: the cause, the place, the value and the remedy, in time.
#include <pcl_spiral/io/toolpath_reader.h>

#include "run_program.h"
#include "support/sanitizers.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <sstream>

namespace refusals_test {

namespace {

using Arguments = std::vector<std::string>;
using Point = std::array<double, 3>;
using Points = std::vector<Point>;

constexpr std::size_t megabyte = 1 << 20;

/** Points over a disc of the given radius about the origin, at the height from \p height. */
Points
disc(int count, double radius, const std::function<double(double, double)>& height, unsigned seed = 5)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Points points;
  for (int i = 0; i < count; ++i) {
    const double r = radius * std::sqrt(unit(random)), angle = 2.0 * M_PI * unit(random);
    const double x = r * std::cos(angle), y = r * std::sin(angle);
    points.push_back({x, y, height(x, y)});
  }
  return points;
}

double
onBall(double x, double y)
{
  return std::sqrt(1e4 - x * x - y * y) - 100.0;
}

/** A cap of a ball of radius 100 mm. */
Points
cap(int count, double radius = 40.0, unsigned seed = 5)
{
  return disc(count, radius, onBall, seed);
}

Points
moved(Points points, double x, double y, double z, double scale = 1.0)
{
  for (Point& p : points)
    p = {scale * p[0] + x, scale * p[1] + y, scale * p[2] + z};
  return points;
}

Points
operator+(Points a, const Points& b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

class Refusals : public ::testing::Test {
protected:
  RunResult run(const Points& points, Arguments arguments)
  {
    std::ostringstream text;
    text.precision(9);
    for (const Point& p : points)
      text << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    writeText(folder_.path("scan.xyz"), text.str());
    arguments.insert(arguments.begin(), {"scan.xyz", "-o", "a.csv", "-o", "a.json"});
    if (std::find(arguments.begin(), arguments.end(), "--tool-radius") == arguments.end())
      arguments.insert(arguments.end(), {"--tool-radius", "3"});
    if (std::find(arguments.begin(), arguments.end(), "--scallop") == arguments.end())
      arguments.insert(arguments.end(), {"--scallop", "0.02"});
    return endOf(startProgram(PCL_SPIRAL_TOOLPATH_PROGRAM, arguments, folder_), folder_);
  }

  /** The run must end with \p code, print all of \p words, and leave no path. */
  void expectRefused(const Points& points, const Arguments& arguments, int code, const std::vector<std::string>& words)
  {
    const RunResult result = run(points, arguments);
    EXPECT_EQ(result.code, code) << result.err;
    for (const std::string& word : words)
      EXPECT_NE(result.err.find(word), std::string::npos) << "without '" << word << "': " << result.err;
    EXPECT_FALSE(std::filesystem::exists(folder_.path("a.csv")));
    expectSmall(result);
  }

  static void expectSmall(const RunResult& result) { EXPECT_TRUE(sanitized || result.peak_memory < 500 * megabyte) << result.peak_memory; }

  /** Of the last run. */
  nlohmann::json report() const { return nlohmann::json::parse(readText(folder_.path("a.json"))); }

  ScratchFolder folder_;
};

} // namespace

TEST_F(Refusals, SurfacesWithoutABoundary)
{
  std::mt19937 random(6);
  std::normal_distribution<double> normal;
  Points ball, opened;
  while (ball.size() < 8000) {
    const Point p{normal(random), normal(random), normal(random)};
    const double scale = 50.0 / std::hypot(p[0], p[1], p[2]);
    ball.push_back({scale * p[0], scale * p[1], scale * p[2]});
    if (ball.back()[2] < 48.5)
      opened.push_back(ball.back());
  }
  expectRefused(ball, {}, 1, {"is closed", "no boundary", "from (-", "to (", "keep only the side"});
  expectRefused(opened, {}, 1, {"is closed", "longest loop", "mm across at (", "gap in the scan"});
}

TEST_F(Refusals, SeveralParts)
{
  const Points part = cap(6000), other = moved(cap(2000, 25.0, 6), 150.0, 0.0, 20.0);
  expectRefused(part + other, {}, 1, {"2 separate parts", "mm2 at (0", "mm2 at (1", "--largest"});
  ASSERT_EQ(run(part, {}).code, 0);
  const std::string alone = readText(folder_.path("a.csv"));
  const RunResult result = run(part + other, {"--largest"});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(readText(folder_.path("a.csv")), alone) << "the other part leaves no trace";
  EXPECT_NE(result.err.find("kept only the largest of 2 separate parts"), std::string::npos) << result.err;
  EXPECT_NE(result.out.find("2000 in other parts, 6000 used"), std::string::npos) << result.out;
  EXPECT_EQ(report().at("surface").at("left_out_parts"), 1);
  EXPECT_EQ(report().at("surface").at("left_out_points"), 2000);
  EXPECT_EQ(report().at("settings").at("largest"), true);
  // The larger part, not the part with more points.
  const Points dense = moved(cap(9000, 10.0, 6), 150.0, 0.0, 20.0);
  writeText(folder_.path("job.yaml"), "largest: true\n");
  ASSERT_EQ(run(part + dense, {"--config", "job.yaml"}).code, 0);
  EXPECT_EQ(readText(folder_.path("a.csv")), alone);
}

TEST_F(Refusals, ScansThatDoNotHangTogether)
{
  Points islands;
  for (int i = 0; i < 100; ++i)
    islands = islands + moved(cap(80, 5.0, 10 + i), 30.0 * (i % 10), 30.0 * (i / 10), 0.0);
  expectRefused(islands, {}, 1, {"separate parts", "mm2 at (", "is disconnected", "--largest"});
  // Half of it is a thousand times denser: these are not outliers to leave out with a warning.
  expectRefused(cap(3000) + moved(cap(6000), 300.0, 0.0, 0.0, 1e-4),
                {"--tool-radius", "0.001", "--scallop", "0.0001", "--chord-error", "0.0005"}, 1,
                {"of 9000 points are isolated", "lies around (300, ", "--thin"});
}

TEST_F(Refusals, ThinDoubleWalls)
{
  for (const double apart : {1.0, 3.0})
    expectRefused(cap(6000) + moved(cap(6000, 40.0, 6), 0.0, 0.0, -apart), {}, 1,
                  {"not a single sheet", "thin double wall", "mm at (", "keep only one side", "folds of the part", "scan more densely"});
}

TEST_F(Refusals, CentresOffThePart)
{
  const Points part = cap(6000);
  expectRefused(part, {"--center", "80,0,-20"}, 2,
                {"centre (80, 0, -20)", "nearest point is (3", "mm away", "three spacings", "inside its rim"});
  Points ring;
  for (const Point& p : cap(8000))
    if (std::hypot(p[0], p[1]) > 18.0)
      ring.push_back(p);
  expectRefused(ring, {"--center", "0,0,0"}, 2, {"centre was given, (0, 0, 0)", "two boundaries", "leave the centre out"});
}

TEST_F(Refusals, CuttersLargerThanAHollow)
{
  const auto dented = [](double x, double y) {
    const double squared = (x - 15.0) * (x - 15.0) + (y - 10.0) * (y - 10.0);
    return -6.0 * std::exp(-squared / 72.0); // radius 6 at the bottom
  };
  const Points part = disc(12000, 50.0, dented);
  const Arguments large{"--tool-radius", "10", "--tight", "refuse"};
  expectRefused(part, large, 1, {"hollow with radius ", "tighter than the tool radius 10 mm", "would gouge", "smaller tool"});
  const std::string message = run(part, large).err, before = " mm at (";
  std::istringstream place(message.substr(message.find(before) + before.size()));
  double x = 0.0, y = 0.0;
  char comma = ' ';
  ASSERT_TRUE(place >> x >> comma >> y) << message;
  EXPECT_LT(std::hypot(x - 15.0, y - 10.0), 8.0) << message;
  const std::string remedy = "a radius of ", named = message.substr(message.find(remedy) + remedy.size());
  EXPECT_EQ(run(part, {"--tool-radius", named.substr(0, named.find(' ')), "--tight", "refuse"}).code, 0) << message;
  EXPECT_EQ(run(part, {"--tool-radius", "10", "--tight", "ride"}).code, 0) << "the other remedy";
  EXPECT_EQ(run(part, {}).code, 0);
}

TEST_F(Refusals, TooFewPoints)
{
  const double nan = std::nan("");
  expectRefused(Points(500, {nan, nan, nan}), {}, 1, {"none of the 500 points is finite", "check the scan"});
  expectRefused(cap(30), {}, 1, {"30 usable points", "at least 50"});
  Points strip;
  for (int x = 0; x < 21; ++x)
    for (int y = 0; y < 3; ++y)
      strip.push_back({1.0 * x, 1.0 * y, 0.0});
  expectRefused(strip, {}, 1, {"too narrow for the spacing of its points", "its middle (", "mm from the rim", "scan more densely"});
  Points rows;
  for (int x = 0; x < 30; ++x)
    for (int y = 0; y < 2; ++y)
      rows.push_back({1.0 * x, 1.0 * y, 0.0});
  expectRefused(rows, {}, 1, {"too narrow for the spacing of its points", "boundary at (", "scan more densely"});
}

TEST_F(Refusals, PathsTooLargeToMake)
{
  const std::vector<std::string> words{"this path would be too large", "points (", "turns", "GB", "--units", "scallop height"};
  const auto start = std::chrono::steady_clock::now();
  expectRefused(moved(cap(6000), 0.0, 0.0, 0.0, 1e4), {}, 2, words); // a part of 800 m
  const Points part = cap(6000);
  for (const char* scallop : {"1e-12", "1e-200"})
    expectRefused(part, {"--scallop", scallop}, 2, words);
  for (const char* step : {"1e-7", "1e-12", "1e-300"})
    expectRefused(part, {"--max-step", step}, 2, words);
  for (const char* error : {"1e-12", "1e-300"})
    for (const char* method : {"radial", "constant-scallop", "shortest"})
      expectRefused(part, {"--chord-error", error, "--method", method}, 2, words);
  expectRefused(part, {"--scallop", "1e-6", "--method", "constant-scallop"}, 1,
                {"at a scallop height of 1e-06 mm turns", "would be needed", "GB of memory", "raise the scallop height"});
  expectRefused(part, {"--tool-radius", "1e-6", "--scallop", "1e-8", "--chord-error", "1e-8"}, 2, words);
  expectRefused(part, {"--threads", "100000"}, 2, {"--threads 100000", "256"});
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(sanitized ? 600 : 60));
}

TEST_F(Refusals, PathsLargerThanTheMemoryLeft)
{
  if (sanitized)
    GTEST_SKIP() << "no address is left to a sanitizer";
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_AS, &before), 0);
  rlimit small = before;
  small.rlim_cur = 1000 * megabyte;
  ASSERT_EQ(::setrlimit(RLIMIT_AS, &small), 0);
  expectRefused(cap(6000), {"--scallop", "1e-8", "--threads", "2"}, 2, {"too large", "GB of memory", "GB are free"});
  ASSERT_EQ(::setrlimit(RLIMIT_AS, &before), 0);
}

TEST_F(Refusals, ClustersOfFarPointsEndInTime)
{
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  for (const double far : {1e4, 1e9})
    for (const int count : {40, 400}) {
      Points cluster;
      for (int i = 0; i < count; ++i)
        cluster.push_back({far + normal(random) * far * 1e-3, normal(random), 0.01 * normal(random)});
      const RunResult result = run(cap(6000) + cluster, {});
      const bool said = result.err.find("left out") != std::string::npos || result.err.find("separate parts") != std::string::npos;
      EXPECT_TRUE(said) << result.err;
      EXPECT_EQ(result.code, result.err.find("separate parts") != std::string::npos ? 1 : 0) << result.err;
      expectSmall(result);
    }
}

TEST_F(Refusals, WarningsAboutUnitsAndNoise)
{
  const auto warnings = [this](const Points& points, const Arguments& arguments) {
    const RunResult result = run(points, arguments);
    EXPECT_EQ(result.code, 0) << result.err;
    const nlohmann::json told = report().at("warnings");
    const std::string all = told.dump();
    for (const auto& warning : told)
      EXPECT_NE(result.err.find(warning.get<std::string>()), std::string::npos) << "said on the terminal too: " << warning;
    return all;
  };
  const auto has = [](const std::string& all, const std::string& words) { return all.find(words) != std::string::npos; };
  const Points part = cap(6000);
  EXPECT_EQ(warnings(part, {}), "[]");
  const std::string huge = warnings(moved(part, 0.0, 0.0, 0.0, 4e3), {"--tool-radius", "2000", "--scallop", "200", "--chord-error", "20"});
  EXPECT_TRUE(has(huge, "mm across: is it in another unit?")) << huge;
  EXPECT_TRUE(has(warnings(part, {"--tool-radius", "40", "--scallop", "39"}), "one or two turns"));
  EXPECT_TRUE(has(warnings(part, {"--tool-radius", "0.4", "--scallop", "0.1"}), "more than the cutter's width"));
  std::mt19937 random(8);
  std::normal_distribution<double> normal(0.0, 0.05);
  Points noisy = part;
  for (Point& p : noisy)
    p[2] += normal(random);
  EXPECT_TRUE(has(warnings(noisy, {}), "scallop height asked for, 0.02 mm, is below the noise of the scan, 0.0"));
  EXPECT_FALSE(has(warnings(noisy, {"--scallop", "0.1"}), "noise"));
  // Isolated points and clusters are one message.
  const Points cluster = moved(cap(90, 4.0), 0.0, 0.0, 60.0);
  const std::string said = warnings(part + cluster + Points{{0.0, 0.0, 500.0}}, {"--clusters", "leave-out"});
  EXPECT_TRUE(has(said, "91 outliers were left out: 1 isolated")) << said;
  EXPECT_TRUE(has(said, "90 in clusters apart from the surface")) << said;
}

} // namespace refusals_test
