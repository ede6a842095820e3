// SPDX-License-Identifier: BSD-3-Clause
// The main program from outside: exit codes, messages on stderr, and files written or not written.
#include "core/tilted_axes.h"
#include <pcl_spiral/io/toolpath_reader.h>

#include "run_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <random>
#include <sstream>
#include <utility>

namespace command_line_test {

namespace {

using Arguments = std::vector<std::string>;
using Point = std::array<double, 3>;

const std::string program = PCL_SPIRAL_TOOLPATH_PROGRAM;

std::string
xyz(const std::vector<Point>& points)
{
  std::ostringstream text;
  text.precision(9);
  for (const Point& p : points)
    text << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  return text.str();
}

/** A cap of a sphere of radius 100 mm, with a rim of radius 40 mm; uniform over its disc. */
std::vector<Point>
cap(int count, double centre_z = -100.0)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) {
    const double r = 40.0 * std::sqrt(unit(random)), angle = 2.0 * M_PI * unit(random);
    points.push_back({r * std::cos(angle), r * std::sin(angle), centre_z + std::sqrt(1e4 - r * r)});
  }
  return points;
}

std::vector<Point>
sphere(int count)
{
  std::mt19937 random(6);
  std::normal_distribution<double> normal;
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) {
    const Point p{normal(random), normal(random), normal(random)};
    const double scale = 50.0 / std::hypot(p[0], p[1], p[2]);
    points.push_back({scale * p[0], scale * p[1], scale * p[2]});
  }
  return points;
}

class CommandLine : public ::testing::Test {
protected:
  void SetUp() override { writeText(folder_.path("cap.xyz"), xyz(cap(6000))); }

  RunResult run(const Arguments& arguments) { return endOf(startProgram(program, arguments, folder_), folder_); }

  /** Runs with a 3 mm ball and 0.02 mm scallop. */
  RunResult make(const std::string& scan, Arguments arguments)
  {
    arguments.insert(arguments.begin(), {scan, "--tool-radius", "3", "--scallop", "0.02"});
    return run(arguments);
  }

  /** The call must end with \p code, print \p words on stderr and nothing on stdout, and not change the
   * folder. */
  void expectRefused(const Arguments& arguments, int code, const std::vector<std::string>& words)
  {
    const std::size_t before = folder_.count();
    const RunResult result = run(arguments);
    std::string call;
    for (const std::string& argument : arguments)
      call += argument + " ";
    EXPECT_EQ(result.code, code) << call << "\n" << result.err;
    for (const std::string& word : words)
      EXPECT_NE(result.err.find(word), std::string::npos) << call << "\nwithout '" << word << "': " << result.err;
    EXPECT_EQ(result.out, "") << call;
    EXPECT_EQ(folder_.count(), before) << call << "\nleft a file behind";
  }

  /** The outputs a.csv, a.pcd and a.json must hold a path from about the middle of the cap to its rim. */
  void expectWholePath()
  {
    const auto csv = pcl_spiral::readToolpath(folder_.path("a.csv"));
    const auto pcd = pcl_spiral::readToolpath(folder_.path("a.pcd"));
    ASSERT_GT(csv.path.size(), 500U);
    EXPECT_EQ(csv.path.size(), pcd.path.size());
    for (const auto& point : pcd.path) {
      ASSERT_NEAR(std::hypot(point.x, point.y, point.z + 100.0), 100.0, 0.01) << "on the sphere";
      ASSERT_GT(point.normal_z, 0.0f);
    }
    EXPECT_NEAR(pcd.path.front().x, 0.0, 3.0) << "from the centre";
    EXPECT_NEAR(std::hypot(pcd.path.back().x, pcd.path.back().y), 40.0, 1.5) << "to the rim";
    const std::string report = readText(folder_.path("a.json"));
    for (const char* word : {"\"tool_radius\": 3.0", "\"input_points\": 6000", "\"outer\"", "\"warnings\"", "\"stages\""})
      EXPECT_NE(report.find(word), std::string::npos) << word;
  }

  ScratchFolder folder_;
};

} // namespace

TEST_F(CommandLine, HelpShowsEveryOptionWithAnExample)
{
  const RunResult result = run({"--help"});
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.err, "");
  for (const char* option :
       {"tool-radius", "scallop",    "chord-error", "max-step",  "tilt",   "lead",   "max-axis-rate",  "feed",          "center",
        "start",       "view-point", "boundaries",  "direction", "sense",  "pitch",  "lines",          "gaps",          "thin",
        "outliers",    "units",      "columns",     "threads",   "config", "origin", "axis-smoothing", "axis-deviation"}) {
    std::istringstream words(result.out);
    const std::string name = std::string("--") + option;
    EXPECT_GE(std::count(std::istream_iterator<std::string>(words), {}, name), 2) << "no example of " << option;
  }
  EXPECT_EQ(run({"--version"}).out.rfind("pcl_spiral_toolpath 0.", 0), 0U);
}

TEST_F(CommandLine, StartsAgainForThreadsThatSleepAndLargePagesAndEndsTheSame)
{
  struct Given {
    std::string policy, pages;
    int starts;
  };
  for (const Given& given : {Given{"-uOMP_WAIT_POLICY", "-uGLIBC_TUNABLES", 2}, Given{"OMP_WAIT_POLICY=active", "-uGLIBC_TUNABLES", 2},
                             Given{"-uOMP_WAIT_POLICY", "GLIBC_TUNABLES=glibc.malloc.hugetlb=0", 2},
                             Given{"OMP_WAIT_POLICY=active", "GLIBC_TUNABLES=glibc.malloc.hugetlb=0", 1}}) {
    const auto ended = [&](const Arguments& arguments) {
      Arguments all{given.policy, given.pages, "OMP_DISPLAY_ENV=true", program};
      if (given.pages[0] == '-') // what env takes away stands first
        std::swap(all[0], all[1]);
      all.insert(all.end(), arguments.begin(), arguments.end());
      return endOf(startProgram("/usr/bin/env", all, folder_), folder_);
    };
    const RunResult version = ended({"--version"});
    EXPECT_EQ(version.code, 0);
    EXPECT_NE(version.out.find("pcl_spiral_toolpath 0."), std::string::npos) << version.out;
    EXPECT_EQ(version.err.find("OMP_WAIT_POLICY = 'PASSIVE'") != std::string::npos, given.policy[0] == '-') << version.err;
    int starts = 0; // the OpenMP library shows its environment each time
    for (std::size_t at = 0; (at = version.err.find("DISPLAY ENVIRONMENT BEGIN", at)) != std::string::npos; ++at)
      ++starts;
    EXPECT_EQ(starts, given.starts) << given.policy << ' ' << given.pages << '\n' << version.err;
    EXPECT_EQ(ended({"--no-such-option"}).code, 2);
  }
}

TEST_F(CommandLine, RefusesBadCalls)
{
  const std::string scan = "cap.xyz";
  expectRefused({}, 2, {"no scan"});
  expectRefused({scan, "--scallop", "0.02", "-o", "a.csv"}, 2, {"no --tool-radius is given", "such as --tool-radius 10"});
  expectRefused({scan, "--tool-radius", "3", "-o", "a.csv"}, 2, {"no --scallop is given", "such as --scallop 0.05"});
  for (const char* radius : {"0", "-2"})
    expectRefused({scan, "--scallop", "0.02", "-o", "a.csv", "--tool-radius", radius}, 2,
                  {"--tool-radius " + std::string(radius), "above 0"});
  expectRefused({scan, "--tool-radius", "3", "--scallop", "0.02"}, 2, {"-o"});
  for (const char* scallop : {"0", "-1", "3", "4", "nan", "abc", "0.02mm"})
    expectRefused({scan, "--tool-radius", "3", "--scallop", scallop, "-o", "a.csv"}, 2, {"--scallop", scallop});
  const auto with = [&scan](const Arguments& more) {
    Arguments arguments{scan, "--tool-radius", "3", "--scallop", "0.02", "-o", "a.csv"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  };
  expectRefused(with({"--chord-error", "0"}), 2, {"--chord-error"});
  expectRefused(with({"--tilt", "95"}), 2, {"--tilt", "95"});
  expectRefused(with({"--feed", "0"}), 2, {"--feed"});
  expectRefused(with({"--center", "1,2"}), 2, {"--center", "1,2", "three"});
  expectRefused(with({"--outliers", "16"}), 2, {"--outliers"});
  expectRefused(with({"--pitch", "radial"}), 2, {"--pitch radial", "across|along"});
  expectRefused(with({"--units", "cm"}), 2, {"mm|m|inch"});
  expectRefused(with({"--tool-radius", "5"}), 2, {"--tool-radius", "twice"});
  expectRefused(with({"--scalop", "5"}), 2, {"scalop", "did you mean 'scallop'"});
  expectRefused(with({"--chord", "5"}), 2, {"did you mean 'chord-error'"});
  expectRefused(with({"-o", "a.dwg"}), 2, {"a.dwg", ".csv"});
  expectRefused(with({"-o", "a.csv"}), 2, {"a.csv", "twice"});
  expectRefused(with({"other.xyz"}), 2, {"other.xyz"});
  expectRefused({"cap.ply", "--tool-radius", "3", "--scallop", "1", "-o"}, 2, {"output"});
}

TEST_F(CommandLine, RefusesOptionsThatDoNotFitTheScan)
{
  std::vector<Point> ring;
  for (const Point& p : cap(8000))
    if (std::hypot(p[0], p[1]) > 18.0)
      ring.push_back(p);
  writeText(folder_.path("ring.xyz"), xyz(ring));
  const auto refused = [this](const std::string& scan, Arguments more, int code, const std::vector<std::string>& words) {
    Arguments arguments{scan, "--scallop", "0.02", "-o", "a.csv"};
    if (std::find(more.begin(), more.end(), "--tool-radius") == more.end())
      more.insert(more.end(), {"--tool-radius", "3"});
    arguments.insert(arguments.end(), more.begin(), more.end());
    expectRefused(arguments, code, words);
  };
  refused("cap.xyz", {"--center", "0,0,500"}, 2, {"cap.xyz", "centre (", "500", "within three spacings"});
  refused("ring.xyz", {"--center", "20,0,-2"}, 2, {"ring.xyz", "centre", "two boundaries", "leave the centre out"});
  refused("cap.xyz", {"--boundaries", "two"}, 2, {"cap.xyz", "two boundaries were set", "set one"});
  refused("cap.xyz", {"--thin", "1e-7"}, 2, {"cap.xyz", "thinning edge", "raise it"});
  // A fault of the scan is not a wrong command line.
  refused("cap.xyz", {"--tool-radius", "300"}, 1, {"cap.xyz", "is the scan in metres"});
}

TEST_F(CommandLine, RefusesBadFilesBeforeAnyWork)
{
  const auto refused = [this](const std::string& scan, const std::string& output, const std::vector<std::string>& words) {
    expectRefused({scan, "--tool-radius", "3", "--scallop", "0.02", "-o", output}, 1, words);
  };
  refused("missing.pcd", "a.csv", {"missing.pcd", "no such file"});
  refused("cap.xyz", "nowhere/a.csv", {"nowhere/a.csv", "does not exist", "create it"});
  refused("cap.xyz", "/proc/a.csv", {"/proc/a.csv", "cannot be written"});
  writeText(folder_.path("empty.ply"), "");
  refused("empty.ply", "a.csv", {"empty.ply", "empty"});
  writeText(folder_.path("letters.xyz"), "1 2 3\n4 five 6\n");
  refused("letters.xyz", "a.csv", {"letters.xyz", "line 2", "five"});
  expectRefused({"cap.xyz", "--tool-radius", "3", "--scallop", "0.02", "-o", "cap.xyz"}, 2, {"cap.xyz"});
  const std::string display = ::getenv("DISPLAY") ? ::getenv("DISPLAY") : "";
  ::unsetenv("DISPLAY");
  refused("cap.xyz", "a.png", {"a.png", "display", "xvfb-run -a"});
  ::setenv("DISPLAY", ":4711", 1);
  refused("cap.xyz", "a.png", {"a.png", ":4711", "xvfb-run -a"});
  display.empty() ? ::unsetenv("DISPLAY") : ::setenv("DISPLAY", display.c_str(), 1);
}

TEST_F(CommandLine, FileNamesStayAsTheyAreInMessages)
{
  const ScratchFolder folder;
  std::filesystem::create_directory(folder.path("setMethod"));
  for (const std::string name : {"setCenter.xyz", "my-setThinning.xyz", "setMethod/scan.xyz"}) {
    writeText(folder.path(name), "1 2 x\n");
    const RunResult result = endOf(startProgram(program, {name, "--tool-radius", "3", "--scallop", "0.1", "-o", "a.csv"}, folder), folder);
    EXPECT_EQ(result.code, 1);
    EXPECT_NE(result.err.find(": " + name), std::string::npos) << result.err;
  }
}

TEST_F(CommandLine, RefusesCloudsWithoutASurfaceToCut)
{
  const auto refused = [this](const std::string& name, const std::vector<Point>& points) {
    writeText(folder_.path(name), xyz(points));
    expectRefused({name, "--tool-radius", "3", "--scallop", "0.02", "-o", "a.csv", "-o", "a.vtp"}, 1, {name});
  };
  const double nan = std::nan("");
  refused("one.xyz", {{1.0, 2.0, 3.0}});
  refused("nans.xyz", std::vector<Point>(500, {nan, nan, nan}));
  refused("same.xyz", std::vector<Point>(500, {1.0, 2.0, 3.0}));
  std::vector<Point> line;
  for (int i = 0; i < 2000; ++i)
    line.push_back({0.05 * i, 0.02 * i, 0.01 * i});
  refused("line.xyz", line);
  refused("sphere.xyz", sphere(8000));
  std::vector<Point> sheets = cap(5000);
  for (const Point& p : cap(5000, -92.0))
    sheets.push_back(p);
  refused("sheets.xyz", sheets);
}

TEST_F(CommandLine, WritesEveryOutputAndSaysSo)
{
  const Arguments outputs{"-o", "a.csv", "-o", "a.pcd", "-o", "a.ply", "-o", "a.vtp", "-o", "a.json"};
  for (const std::string method : {"constant-scallop", "radial"}) {
    Arguments arguments = outputs;
    arguments.insert(arguments.end(), {"--method", method});
    const RunResult result = make("cap.xyz", arguments);
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(folder_.count(), 6U) << "the scan and five outputs";
    for (const char* word :
         {"6000 points", "spacing", method == "radial" ? "centre" : "loops", "turns", "path length", "machining time", "a.csv", "a.json"})
      EXPECT_NE(result.out.find(word), std::string::npos) << word << " in\n" << result.out;
    expectWholePath();
  }
}

TEST_F(CommandLine, SaysWhereTheAxisLeavesTheTilt)
{
  const auto jsonOf = [this](const Arguments& more) {
    Arguments arguments{"-o", "a.csv", "-o", "a.json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const RunResult result = make("cap.xyz", arguments);
    EXPECT_EQ(result.code, 0) << result.err;
    const auto path = nlohmann::json::parse(readText(folder_.path("a.json"))).at("path");
    const std::string words = "from the requested tilt at " + path.at("deviating_points").dump() + " point";
    const bool said = result.out.find(words) != std::string::npos;
    EXPECT_EQ(said, path.at("deviating_points").get<int>() > 0) << result.out;
    return path;
  };
  const auto tilted = jsonOf({"--tilt", "15", "--axis-smoothing", "10", "--axis-deviation", "4"});
  const auto path = pcl_spiral::readToolpath(folder_.path("a.csv")).path; // and in the path itself
  pcl_spiral::Polyline points;
  std::vector<Eigen::Vector3d> normals;
  for (const auto& point : path) {
    points.push_back(point.getVector3fMap().cast<double>());
    normals.push_back(point.getNormalVector3fMap().cast<double>().normalized());
  }
  const auto wanted = pcl_spiral::tiltedAxes(points, normals, 15.0 * M_PI / 180.0, 0.0);
  std::size_t off = 0;
  double largest = 0.0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Eigen::Vector3d axis = path[i].getAxisVector3fMap().cast<double>().normalized();
    const double deviation = std::atan2(axis.cross(wanted[i]).norm(), axis.dot(wanted[i])) * 180.0 / M_PI;
    off += deviation > 4.0;
    largest = std::max(largest, deviation);
  }
  ASSERT_GT(off, 5U);
  EXPECT_NEAR(tilted.at("deviating_points").get<double>(), static_cast<double>(off), 1.0 + 0.05 * off);
  EXPECT_NEAR(tilted.at("largest_axis_deviation").get<double>(), largest, 0.3);
  EXPECT_LE(tilted.at("largest_axis_rate").get<double>(), 10.0001);
  const auto upright = jsonOf({"--tilt", "0", "--axis-smoothing", "0"});
  EXPECT_EQ(upright.at("deviating_points").get<int>(), 0);
  EXPECT_EQ(upright.at("largest_axis_deviation").get<double>(), 0.0);
  EXPECT_NEAR(upright.at("largest_axis_lean").get<double>(), 0.0, 1e-6);
}

TEST_F(CommandLine, DropsBadPointsAndSaysHowMany)
{
  std::vector<Point> points = cap(6000);
  const std::vector<Point> doubled(points.begin(), points.begin() + 1000);
  points.insert(points.end(), doubled.begin(), doubled.end());
  points.insert(points.end(), 77, {std::nan(""), 0.0, 0.0});
  writeText(folder_.path("mixed.xyz"), xyz(points));
  const RunResult result = make("mixed.xyz", {"-o", "a.csv"});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.out.find("77 not finite"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("1000 duplicates"), std::string::npos) << result.out;
  ASSERT_EQ(make("cap.xyz", {"-o", "b.csv", "--quiet"}).code, 0);
  EXPECT_TRUE(readText(folder_.path("a.csv")) == readText(folder_.path("b.csv"))) << "they change nothing";
}

/** Two lines that may be points, and are not: the message says how to skip them, in each program. */
TEST_F(CommandLine, LinesAtTheBeginningAreSkippedAsTheMessageSays)
{
  writeText(folder_.path("head.xyz"), "7 12 scanner\n1,5 2,5 3,5\n" + readText(folder_.path("cap.xyz")));
  ASSERT_EQ(make("cap.xyz", {"-o", "whole.csv"}).code, 0);
  const std::vector<std::pair<std::string, Arguments>> calls{
      {PCL_SPIRAL_TOOLPATH_PROGRAM, {"head.xyz", "--tool-radius", "3", "--scallop", "0.02", "-o", "a.csv"}},
      {PCL_SPIRAL_DRIVE_PROGRAM, {"head.xyz", "--tool-radius", "3", "--step-over", "2", "-o", "b.csv"}},
      {PCL_SPIRAL_VERIFY_PROGRAM, {"head.xyz", "whole.csv", "--tool-radius", "3"}}};
  for (const auto& [name, call] : calls) {
    Arguments followed = call;
    for (int line = 1; line <= 2; ++line) {
      const RunResult refused = endOf(startProgram(name, followed, folder_), folder_);
      EXPECT_EQ(refused.code, 1) << name;
      const std::size_t at = refused.err.find("--skip-lines ");
      ASSERT_NE(at, std::string::npos) << name << ": " << refused.err;
      followed = call;
      followed.insert(followed.end(), {"--skip-lines", std::to_string(std::atoi(refused.err.c_str() + at + 13))});
    }
    const RunResult done = endOf(startProgram(name, followed, folder_), folder_);
    EXPECT_EQ(done.code, 0) << name << ": " << done.err;
  }
  EXPECT_EQ(readText(folder_.path("a.csv")), readText(folder_.path("whole.csv")));
  expectRefused({"cap.xyz", "--tool-radius", "3", "--scallop", "0.02", "-o", "c.csv", "--skip-lines", "-1"}, 2,
                {"--skip-lines -1", "0 lines or more"});
}

/** A bump of 2 mm that smoothing took away: said by each program; a judged path that cuts into it fails. */
TEST_F(CommandLine, TheRawScanBesideTheSmoothedOneIsHeeded)
{
  std::vector<Point> raw = cap(6000);
  for (Point& p : raw)
    p[2] += 2.0 * std::exp(-(p[0] * p[0] + (p[1] - 15.0) * (p[1] - 15.0)) / 20.0);
  writeText(folder_.path("raw.xyz"), xyz(raw));
  const Arguments asked{"--raw-scan", "raw.xyz"};
  const auto with = [](Arguments call, const Arguments& more) {
    call.insert(call.end(), more.begin(), more.end());
    return call;
  };
  const RunResult made = make("cap.xyz", with(asked, {"-o", "a.csv"}));
  EXPECT_EQ(made.code, 0) << made.err;
  EXPECT_NE(made.err.find("which is not noise: the shape was changed there"), std::string::npos) << made.err;
  EXPECT_NE(made.err.find("mm into the raw scan at ("), std::string::npos) << made.err;
  const RunResult judged = make("cap.xyz", with(asked, {"-o", "b.csv", "--verify"}));
  EXPECT_EQ(judged.code, 1);
  EXPECT_NE(judged.err.find("smooth with a smaller radius"), std::string::npos) << judged.err;
  EXPECT_FALSE(std::filesystem::exists(folder_.path("b.csv")));
  const Arguments verify{"cap.xyz", "a.csv", "--tool-radius", "3", "--scallop", "0.02", "--max-gouge", "0.1"};
  EXPECT_EQ(endOf(startProgram(PCL_SPIRAL_VERIFY_PROGRAM, verify, folder_), folder_).code, 0);
  EXPECT_EQ(endOf(startProgram(PCL_SPIRAL_VERIFY_PROGRAM, with(verify, asked), folder_), folder_).code, 1);
  const RunResult passes = endOf(
      startProgram(PCL_SPIRAL_DRIVE_PROGRAM, with({"cap.xyz", "--tool-radius", "3", "--step-over", "2", "-o", "d.csv"}, asked), folder_),
      folder_);
  EXPECT_EQ(passes.code, 0);
  EXPECT_NE(passes.err.find("the shape was changed there"), std::string::npos) << passes.err;
  expectRefused(with({"cap.xyz", "--tool-radius", "3", "--scallop", "0.02", "-o", "c.csv"}, {"--raw-scan", "none.xyz"}), 1, {"none.xyz"});
  writeText(folder_.path("far.xyz"), xyz(cap(500, 900.0)));
  expectRefused(with({"cap.xyz", "--tool-radius", "3", "--scallop", "0.02", "-o", "c.csv"}, {"--raw-scan", "far.xyz"}), 1,
                {"far.xyz", "500 of 500 points of this raw scan", "is it another part, another unit"});
}

TEST_F(CommandLine, UnitsAndThreadsDoNotChangeThePath)
{
  std::vector<Point> metres = cap(6000);
  for (Point& p : metres)
    for (double& c : p)
      c /= 1000.0;
  std::ostringstream text;
  text.precision(12);
  for (const Point& p : metres)
    text << p[0] << ',' << p[1] << ',' << p[2] << '\n';
  writeText(folder_.path("metres.csv"), text.str());
  ASSERT_EQ(make("cap.xyz", {"-o", "mm.csv", "--threads", "1"}).code, 0);
  const RunResult metre_run = make("metres.csv", {"-o", "m.csv", "--units", "m", "--threads", "2", "--quiet"});
  ASSERT_EQ(metre_run.code, 0) << metre_run.err;
  EXPECT_EQ(metre_run.out + metre_run.err, "");
  const auto a = pcl_spiral::readToolpath(folder_.path("mm.csv")).path;
  const auto b = pcl_spiral::readToolpath(folder_.path("m.csv")).path;
  EXPECT_NEAR(a.back().arc_length, b.back().arc_length, 1e-3 * a.back().arc_length);
}

TEST_F(CommandLine, LimitsOfTheCheckDecideWhetherThePathIsWritten)
{
  const RunResult kept = make("cap.xyz", {"--max-gouge", "0.05", "--max-uncut", "1", "-o", "kept.csv", "-o", "kept.json"});
  EXPECT_EQ(kept.code, 0) << kept.err;
  EXPECT_NE(readText(folder_.path("kept.json")).find("\"gouge\""), std::string::npos) << "checked without --verify";
  const std::size_t before = folder_.count();
  const RunResult broken = make("cap.xyz", {"--max-scallop", "0.0001", "-o", "broken.csv", "-o", "broken.json"});
  EXPECT_EQ(broken.code, 1);
  EXPECT_NE(broken.err.find("a limit is broken: --max-scallop 0.0001"), std::string::npos) << broken.err;
  EXPECT_EQ(folder_.count(), before);
  expectRefused({"cap.xyz", "--tool-radius", "3", "--scallop", "0.02", "--max-gouge", "-1", "-o", "b.csv"}, 2,
                {"--max-gouge -1", "0 mm or more"});
}

TEST_F(CommandLine, AReportMakesItsRunAgain)
{
  std::ostringstream text; // a scan that needs its options: columns in another order, metres, map coordinates
  text.precision(12);
  for (const Point& p : cap(6000))
    text << p[2] / 1000.0 << ';' << 2.0 + p[0] / 1000.0 << ';' << 5.0 + p[1] / 1000.0 << '\n';
  writeText(folder_.path("metres.csv"), text.str());
  writeText(folder_.path("job.yaml"), "tilt: 7.25\ncenter: [1.5, -2, 0]\nrim: \"inside,0.5\"\nflip-normals: false\nthreads: 1\n");
  const RunResult first = make("metres.csv", {"--config", "job.yaml", "--units", "m", "--columns", "z,x,y", "--origin", "2,5,0", "--method",
                                              "radial", "--sense", "cw", "--feed", "2500", "-o", "first.csv", "-o", "first.json"});
  ASSERT_EQ(first.code, 0) << first.err;
  const std::string path = readText(folder_.path("first.csv"));
  std::filesystem::remove(folder_.path("job.yaml")); // the report holds its options
  const RunResult again = run({"--config", "first.json", "-o", "again.csv", "-o", "again.json"});
  ASSERT_EQ(again.code, 0) << again.err;
  EXPECT_TRUE(readText(folder_.path("again.csv")) == path);
  const RunResult third = run({"--config", "again.json", "-o", "third.csv", "--tilt", "0"});
  ASSERT_EQ(third.code, 0) << third.err;
  EXPECT_FALSE(readText(folder_.path("third.csv")) == path) << "the command line has priority";
  // Without an output, the report's own are written.
  std::filesystem::remove(folder_.path("first.csv"));
  const RunResult same = run({"--config", "first.json"});
  ASSERT_EQ(same.code, 0) << same.err;
  EXPECT_TRUE(readText(folder_.path("first.csv")) == path);

  writeText(folder_.path("old.json"), "{\"settings\": {\"tool_radius\": 3.0, \"scallop\": 0.02}}\n");
  expectRefused({"cap.xyz", "--config", "old.json", "-o", "b.csv"}, 1, {"old.json", "does not have the options of its run"});
}

TEST_F(CommandLine, JobFileHoldsTheSameNamesAndTheCommandLineWins)
{
  writeText(folder_.path("job.yaml"), "scan: cap.xyz\noutput: [a.csv, a.json]\ntool-radius: 6\nscallop: 0.02\n"
                                      "center: [0, 0, 0]\nfeed: 2500\nflip-normals: false\n");
  const RunResult result = run({"--config", "job.yaml", "--tool-radius", "3"});
  ASSERT_EQ(result.code, 0) << result.err;
  const std::string report = readText(folder_.path("a.json"));
  EXPECT_NE(report.find("\"tool_radius\": 3.0"), std::string::npos) << report;
  EXPECT_EQ(pcl_spiral::readToolpath(folder_.path("a.csv")).feed.at(0), 2500.0);

  writeText(folder_.path("wrong.yaml"), "tool-radius: 3\nscalop: 0.02\n");
  expectRefused({"cap.xyz", "--config", "wrong.yaml", "-o", "b.csv"}, 2, {"wrong.yaml", "line 2", "scalop", "did you mean 'scallop'"});
  writeText(folder_.path("broken.yaml"), "tool-radius: [3\n");
  expectRefused({"cap.xyz", "--config", "broken.yaml", "-o", "b.csv"}, 1, {"broken.yaml"});
  expectRefused({"cap.xyz", "--config", "none.yaml", "-o", "b.csv"}, 1, {"none.yaml"});
}

TEST_F(CommandLine, AFailureKeepsEarlierOutputs)
{
  writeText(folder_.path("a.csv"), "earlier");
  writeText(folder_.path("one.xyz"), "1 2 3\n");
  expectRefused({"one.xyz", "--tool-radius", "3", "--scallop", "0.02", "-o", "a.csv"}, 1, {"one.xyz"});
  EXPECT_EQ(readText(folder_.path("a.csv")), "earlier");
}

TEST_F(CommandLine, ControlCLeavesNothingBehind)
{
  writeText(folder_.path("large.xyz"), xyz(cap(300000)));
  for (const int signal : {SIGINT, SIGTERM}) {
    const pid_t process = startProgram(program, {"large.xyz", "--tool-radius", "1", "--scallop", "0.0005", "-o", "a.csv"}, folder_);
    ASSERT_TRUE(waitUntilCaught(process, signal));
    std::this_thread::sleep_for(std::chrono::milliseconds(200)); // the work has begun
    ASSERT_EQ(::kill(process, signal), 0);
    const RunResult result = endOf(process, folder_);
    EXPECT_EQ(result.code, 1);
    EXPECT_NE(result.err.find("cancelled"), std::string::npos) << result.err;
    EXPECT_EQ(folder_.count(), 2U) << "the two scans";
  }
}

} // namespace command_line_test
