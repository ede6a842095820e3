// SPDX-License-Identifier: BSD-3-Clause
// pcl_spiral_ridge from outside: files of a beam's rows, a cutter on the ridge and on a scan, both lines from a scan, and messages for
// wrong command lines.
#include "run_program.h"
#include "support/ridges.h"

#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/io/toolpath_reader.h>
#include <pcl_spiral/verify/material_removal.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <iomanip>
#include <set>
#include <sstream>

namespace ridge_test {

namespace {

using namespace pcl_spiral::test;
using Eigen::Vector3d;

const ExactRidge die = dieRidge();

std::string
textOf(const std::vector<Vector3d>& points)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(7);
  for (const Vector3d& p : points)
    text << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  return text.str();
}

/** Points of the whole ridge, \p spacing apart, and by the share \p beyond past the ends of both lines. */
std::vector<Vector3d>
scanOf(double spacing, double beyond)
{
  const int along = static_cast<int>(640.0 / spacing), across = static_cast<int>(27.0 / spacing);
  std::vector<Vector3d> points;
  for (int i = 0; i <= along; ++i)
    for (int j = 0; j <= across; ++j)
      points.push_back(die.position(-beyond + (1.0 + 2.0 * beyond) * i / along, -beyond + (1.0 + 2.0 * beyond) * j / across));
  return points;
}

class RidgeProgram : public ::testing::Test {
protected:
  RidgeProgram()
  {
    writeText(folder_.path("rail.txt"), textOf(die.railPoints(300)));
    writeText(folder_.path("generator.txt"), textOf(die.generatorPoints(0.37, 100)));
  }

  RunResult run(const std::vector<std::string>& arguments)
  {
    return endOf(startProgram(PCL_SPIRAL_RIDGE_PROGRAM, arguments, folder_), folder_);
  }

  /** With both lines. */
  RunResult runLines(std::vector<std::string> arguments)
  {
    arguments.insert(arguments.begin(), {"rail.txt", "generator.txt"});
    return run(arguments);
  }

  std::set<std::string> files() const
  {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.root()))
      names.insert(entry.path().filename().string());
    return names;
  }

  void expectRefused(const std::vector<std::string>& arguments, int code, const std::string& words)
  {
    const std::set<std::string> before = files();
    const RunResult result = run(arguments);
    EXPECT_EQ(result.code, code) << words << '\n' << result.err;
    EXPECT_NE(result.err.find(words), std::string::npos) << "'" << words << "' in: " << result.err;
    EXPECT_EQ(files(), before) << words;
  }

  ScratchFolder folder_;
};

/** Heights that a ball of radius 6 leaves, judged on points of the exact ridge. */
pcl_spiral::RemovalReport
judged(const std::string& path_file)
{
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const Vector3d& p : scanOf(0.5, 0.0))
    cloud->emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()));
  pcl_spiral::MaterialRemoval<pcl::PointXYZ> removal;
  removal.setInputCloud(cloud);
  removal.setToolRadius(6.0);
  removal.setScallopHeight(0.02);
  removal.setQuiet(true);
  removal.setInputToolpath(pcl::make_shared<pcl::PointCloud<pcl_spiral::ToolpathPoint>>(pcl_spiral::readToolpath(path_file).path));
  pcl::PointCloud<pcl::PointXYZI> stock;
  removal.compute(stock);
  EXPECT_TRUE(removal.getStatus().ok()) << removal.getStatus().message();
  return removal.getReport();
}

constexpr double chord_error = 0.005, scallop = 0.02;

void
expectWithin(const pcl_spiral::RemovalReport& figures)
{
  EXPECT_LE(figures.scallop.p999, 1.02 * scallop + chord_error);
  EXPECT_GE(figures.scallop.p50, 0.8 * scallop); // and the rows are not much closer than needed
  EXPECT_LE(figures.gouge.value, chord_error + 0.002);
  EXPECT_EQ(figures.stock.uncut, 0U);
  EXPECT_GT(figures.stock.samples, 40000U);
}

} // namespace

TEST_F(RidgeProgram, WritesABeamsRowsInEveryFormat)
{
  const std::vector<std::string> named{"a.csv", "a.vtp", "a.6d", "a.5d", "a.json", "a.ngc", "a.png"};
  std::vector<std::string> arguments{"--spot",       "4",      "--overlap",  "0.25",  "--stand-off", "10",
                                     "--pass-begin", "M62 P0", "--pass-end", "M63 P0"};
  for (const std::string& name : named)
    arguments.insert(arguments.end(), {"-o", name});
  const RunResult result = runLines(arguments);
  ASSERT_EQ(result.code, 0) << result.err;
  std::set<std::string> expected{"rail.txt", "generator.txt", "a_lines.png", "a_normals.png", "a_rotary.png"};
  expected.insert(named.begin(), named.end());
  EXPECT_EQ(files(), expected);
  for (const std::string& name : expected)
    EXPECT_GT(std::filesystem::file_size(folder_.path(name)), 500U) << name;

  const auto report = nlohmann::json::parse(readText(folder_.path("a.json")));
  const std::size_t rows = report.at("rows").at("count");
  EXPECT_GE(rows, 9U); // the generator is 26.8 mm long, and rows are 3 mm apart at most
  EXPECT_NEAR(report.at("ridge").at("chord_angle").get<double>(), -15.0, 0.01);
  std::istringstream list(readText(folder_.path("a.6d")));
  std::size_t lines = 0, gaps = 0;
  for (std::string line; std::getline(list, line);) {
    gaps += line.empty();
    if (line.empty() || ++lines % 97 != 0)
      continue;
    Vector3d tip, axis;
    std::istringstream(line) >> tip.x() >> tip.y() >> tip.z() >> axis.x() >> axis.y() >> axis.z();
    EXPECT_LT(die.distance(tip - 10.0 * axis), 0.002); // where the beam meets the ridge
  }
  EXPECT_EQ(lines, report.at("rows").at("points").get<std::size_t>());
  EXPECT_EQ(gaps, rows - 1);
  const std::string program = readText(folder_.path("a.ngc"));
  std::size_t begins = 0;
  for (std::size_t at = program.find("M62 P0\n"); at != std::string::npos; at = program.find("M62 P0\n", at + 1))
    ++begins;
  EXPECT_EQ(begins, rows);
}

TEST_F(RidgeProgram, ABallOnTheRidgeKeepsTheScallopAndDoesNotGouge)
{
  const RunResult result = runLines({"--tool-radius", "6", "--scallop", "0.02", "-o", "cut.csv"});
  ASSERT_EQ(result.code, 0) << result.err;
  expectWithin(judged(folder_.path("cut.csv")));
}

TEST_F(RidgeProgram, ABallOnAScanKeepsClearOfWhatStandsThere)
{
  std::vector<Vector3d> points = scanOf(0.5, 0.0);
  const Vector3d place = die.position(0.5, 0.5), up = die.normal(0.5, 0.5);
  for (double x = -3.0; x <= 3.0; x += 0.4)
    for (double y = -3.0; y <= 3.0; y += 0.4)
      points.push_back(place + Vector3d(x, y, 0.0) + 5.0 * up); // a clamp
  writeText(folder_.path("scan.xyz"), textOf(points));
  const RunResult result = runLines({"--scan", "scan.xyz", "--tool-radius", "6", "--step-over", "4", "-o", "cut.csv"});
  ASSERT_EQ(result.code, 0) << result.err;
  const auto path = pcl_spiral::readToolpath(folder_.path("cut.csv")).path;
  ASSERT_GT(path.size(), 1000U);
  double deepest = 0.0;
  for (const auto& p : path) {
    const Vector3d middle = (p.getVector3fMap() + 6.0f * p.getNormalVector3fMap()).cast<double>();
    for (std::size_t i = points.size() - 256; i < points.size(); ++i)
      deepest = std::max(deepest, 6.0 - (points[i] - middle).norm());
  }
  EXPECT_LT(deepest, 0.02);
}

TEST_F(RidgeProgram, FindsBothLinesInAScan)
{
  writeText(folder_.path("scan.xyz"), textOf(moved(scanOf(0.5, 0.01), 0.02, 1)));
  const auto rough = [](double t) {
    const Vector3d p = die.position(t, 0.45);
    return std::to_string(p.x()) + "," + std::to_string(p.y()) + "," + std::to_string(p.z());
  };
  const RunResult result = run({"--scan", "scan.xyz", "--through", rough(0.02) + "/" + rough(0.3) + "/" + rough(0.6) + "/" + rough(0.98),
                                "--half-width", "8", "--step-over", "2", "-o", "a.6d", "-o", "a.json"});
  ASSERT_EQ(result.code, 0) << result.err;
  std::istringstream list(readText(folder_.path("a.6d")));
  std::size_t lines = 0;
  for (std::string line; std::getline(list, line);) {
    if (line.empty() || ++lines % 61 != 0)
      continue;
    Vector3d p;
    std::istringstream(line) >> p.x() >> p.y() >> p.z();
    EXPECT_LT(die.distance(p), 0.05);
  }
  EXPECT_GT(lines, 1000U);
  const auto report = nlohmann::json::parse(readText(folder_.path("a.json")));
  EXPECT_LT(report.at("found_in_scan").at("misfit").get<double>(), 0.04);
  EXPECT_FALSE(report.contains("rail"));
}

TEST_F(RidgeProgram, TakesAJobFileAndWritesTheSameBytesForAnyNumberOfThreads)
{
  writeText(folder_.path("job.yaml"),
            "rail: rail.txt\ngenerator: generator.txt\nspot: 4\noverlap: 0.25\ndirection: across\noutput: [a.6d]\n");
  ASSERT_EQ(run({"--config", "job.yaml", "--threads", "1"}).code, 0);
  ASSERT_EQ(runLines({"--spot", "4", "--overlap", "0.25", "--direction", "across", "--threads", "7", "-o", "b.6d"}).code, 0);
  EXPECT_EQ(readText(folder_.path("a.6d")), readText(folder_.path("b.6d")));
}

TEST_F(RidgeProgram, ABeamThatWouldStandIsRefused)
{
  std::vector<Vector3d> rail, generator; // a crest with a normal that passes the upright direction
  for (int i = 0; i <= 100; ++i)
    rail.emplace_back(i, 0.0, 0.0);
  for (int i = 0; i <= 60; ++i)
    generator.emplace_back(50.0, 20.0 * std::sin((i - 30) / 30.0), 20.0 * std::cos((i - 30) / 30.0) - 20.0);
  writeText(folder_.path("rail.txt"), textOf(rail));
  writeText(folder_.path("generator.txt"), textOf(generator));
  std::vector<std::string> call{"rail.txt", "generator.txt", "--step-over", "30",         "--direction", "across", "--stand-off",
                                "10",       "--pass-begin",  "M62 P0",      "--pass-end", "M63 P0",      "-o",     "a.ngc"};
  expectRefused(call, 1, "of the feed while it is on, and would burn the part: tilt the beam (--tilt 20)");
  call.insert(call.end(), {"--tilt", "20"});
  EXPECT_EQ(run(call).code, 0);
}

TEST_F(RidgeProgram, SmoothedAxesLeaveABeamsSpotOnItsRow)
{
  ASSERT_EQ(runLines({"--step-over", "20", "--direction", "across", "--stand-off", "10", "--axis-smoothing", "20", "-o", "a.6d"}).code, 0);
  std::istringstream list(readText(folder_.path("a.6d")));
  double largest = 0.0, lean = 0.0;
  for (std::string line; std::getline(list, line);) {
    Vector3d tip, axis;
    if (line.empty())
      continue;
    std::istringstream(line) >> tip.x() >> tip.y() >> tip.z() >> axis.x() >> axis.y() >> axis.z();
    double t = 0.5, w = 0.5;
    largest = std::max(largest, die.distance(tip - 10.0 * axis));
    static_cast<void>(die.distance(tip - 10.0 * axis, t, w));
    lean = std::max(lean, std::acos(std::min(1.0, axis.dot(die.normal(t, w)))));
  }
  EXPECT_LT(largest, 0.002);
  EXPECT_GT(lean, 0.05); // and they were smoothed
}

TEST_F(RidgeProgram, RemediesOfItsMessagesWork)
{
  const RunResult leaning = runLines({"--spot", "4", "--stand-off", "10", "--tilt", "10", "-o", "a.csv"});
  EXPECT_EQ(leaning.code, 0);
  EXPECT_NE(leaning.err.find("meets the surface about 1.763 mm beside the row, at the contacts in the files; to have the tip at the spot, "
                             "leave --stand-off out"),
            std::string::npos)
      << leaning.err;
  EXPECT_EQ(runLines({"--spot", "4", "--tilt", "10", "-o", "a.csv"}).err, "");
  EXPECT_EQ(runLines({"--tool-radius", "6", "--step-over", "4", "-o", "a.apt"}).code, 0) << "several passes";
  EXPECT_EQ(runLines({"--tool-radius", "6", "--step-over", "30", "-o", "a.apt"}).code, 0);
}

TEST_F(RidgeProgram, SaysWhatIsWrongWithACall)
{
  const std::string rail = "rail.txt", generator = "generator.txt";
  const auto call = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {rail, generator, "-o", "x.csv"});
    return more;
  };
  expectRefused({"-o", "x.csv", "--spot", "4"}, 2, "no rail is given; give two files");
  expectRefused({rail, "-o", "x.csv", "--spot", "4"}, 2, "no generator is given; give a second file");
  expectRefused({rail, rail, "-o", "x.csv", "--spot", "4"}, 2, "rail and generator are the same file");
  expectRefused({rail, generator, "third.txt", "-o", "x.csv", "--spot", "4"}, 2,
                "third.txt is a second generator, after generator.txt; give one generator");
  expectRefused({rail, generator, "--spot", "4"}, 2, "no output is given");
  expectRefused({rail, generator, "--spot", "4", "-o", "x.dxf"}, 2, "extension '.dxf' is not known; use");
  writeText(folder_.path("rail.csv"), "x,y,z\n1,2,3\n");
  expectRefused({"rail.csv", generator, "--spot", "4", "-o", "rail.csv"}, 2,
                "this is the rail itself, an input; give the output another name");
  expectRefused({rail, generator, "--spot", "4", "-o", "x_lines.png", "-o", "x.png"}, 2,
                "x_lines.png: is given twice, because it is written with another picture");
  expectRefused(
      call({"--spot", "4", "--stand-off", "-10"}), 2,
      "--stand-off -10: must be from 0 to 100000 mm, such as 10; for the other side of the ridge flip the normals (--flip-normals)");
  expectRefused({rail, generator, "--spot", "4", "-o", "x.apt"}, 2, "this format needs a cutter, and the tool is a beam");
  expectRefused({rail, generator, "--spot", "4", "-o", "none/x.csv"}, 1, "none/x.csv");
  expectRefused(call({}), 2, "no option sets the distance between rows; give one of --spot, --step-over and --scallop");
  expectRefused(call({"--spot", "4", "--step-over", "3"}), 2, "more than one option sets the distance between rows");
  expectRefused(call({"--spot", "0"}), 2, "--spot 0: must be above 0 mm");
  expectRefused(call({"--spot", "4", "--overlap", "1"}), 2, "--overlap 1: must be at least 0 and below 1, such as 0.25");
  expectRefused(call({"--step-over", "4", "--overlap", "0.5"}), 2, "--overlap: belongs to --spot");
  expectRefused(call({"--spot", "4", "--reference", "0,0,0"}), 2,
                "the reference normal has no direction: set a vector such as (0, 0, 1) (--reference)");
  expectRefused(call({"--spot", "4", "--measuring-error", "-1"}), 2,
                "--measuring-error -1: must be above 0 mm, or 0 for the one found from the points, such as 0.02");
  expectRefused(call({"--spot", "4", "--lead", "90"}), 2, "--lead 90: must be above -90 and below 90 degrees, such as 5");
  expectRefused(call({"--scallop", "0.02"}), 2, "--scallop: belongs to a cutter, and no --tool-radius is given");
  expectRefused(call({"--tool-radius", "6", "--spot", "4"}), 2, "--spot: belongs to a beam; for a cutter give --step-over or --scallop");
  expectRefused(call({"--tool-radius", "6", "--step-over", "1", "--stand-off", "3"}), 2, "--stand-off: a cutter touches the surface");
  expectRefused(call({"--tool-radius", "6", "--scallop", "6"}), 2, "--scallop 6: must be above 0 and below the tool radius, which is 6 mm");
  expectRefused(call({"--tool-radius", "6", "--corner-radius", "1", "--scallop", "0.1"}), 2, "known only for a ball");
  expectRefused(call({"--spot", "4", "--scan", "scan.xyz"}), 2, "a beam uses only rail and generator");
  expectRefused(call({"--spot", "4", "--through", "0,0,0/1,1,1"}), 2, "no --scan is given; give the scan that holds the ridge");
  expectRefused(call({"--spot", "4", "--scan", "s.xyz", "--through", "0,0,0/1,1,1"}), 2, "leave out --through or the files");
  expectRefused({"--spot", "4", "-o", "x.csv", "--scan", "s.xyz", "--through", "0,0,0/1,1,1"}, 2, "--half-width 0: must be above 0 mm");
  expectRefused(call({"--spot", "4", "--half-width", "4"}), 2, "--half-width: belongs to --through");
  expectRefused(call({"--spot", "4", "--thin", "1"}), 2, "--thin: belongs to a --scan");
  expectRefused({rail, generator, "-o", "x.ngc", "--spot", "4", "--pass-begin", "M62\nP0", "--pass-end", "M63 P0"}, 2, "--pass-begin");
  expectRefused(call({"--spot", "4", "--pass-begin", "M62 P0", "--pass-end", "M63 P0"}), 2, "--pass-begin");
  expectRefused(call({"--spot", "4", "--spott", "4"}), 2, "did you mean 'spot'?");
}

TEST_F(RidgeProgram, SaysWhatIsWrongWithTheData)
{
  const auto refused = [&](const std::string& rail, const std::string& generator, const std::string& words) {
    expectRefused({rail, generator, "--spot", "4", "-o", "x.csv"}, 1, words);
  };
  refused("none.txt", "generator.txt", "none.txt");
  const std::vector<Vector3d> generator = die.generatorPoints(0.37, 100), rail = die.railPoints(300);
  writeText(folder_.path("three.txt"), textOf({rail[0], rail[1], rail[2]}));
  refused("three.txt", "generator.txt", "the rail has 3 different points");
  writeText(folder_.path("nan.txt"), "1 2 nan\n" + textOf(rail));
  refused("nan.txt", "generator.txt", "point 1 of the rail is not finite");
  writeText(folder_.path("far.txt"), textOf([&] {
              std::vector<Vector3d> far = generator;
              for (Vector3d& p : far)
                p += Vector3d(0, 0, 300);
              return far;
            }()));
  refused("rail.txt", "far.txt", "rail.txt, far.txt: ");
  writeText(folder_.path("half.txt"), textOf(generator) + textOf({generator.back() + Vector3d(0, 30, 0)}));
  refused("rail.txt", "half.txt", "a gap");
  std::vector<Vector3d> bent(rail.begin(), rail.begin() + 100);
  for (int i = 1; i < 100; ++i)
    bent.push_back(bent[99] + 2.0 * i * Vector3d(-0.2, 1.0, 0.0).normalized());
  writeText(folder_.path("bent.txt"), textOf(bent));
  refused("bent.txt", "generator.txt", "corner");
  refused("generator.txt", "rail.txt", "generator.txt, rail.txt: ");
}

} // namespace ridge_test
