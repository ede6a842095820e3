// SPDX-License-Identifier: BSD-3-Clause
// Several regions in one run, each with its own path: two domes over a table with a tower between them, and two halves of one dome. Paths
// are judged by brute force against the exact domes, and the ways between them against every point of the scan.
#include <pcl_spiral/io/machine_reader.h>
#include <pcl_spiral/io/program_reader.h>
#include <pcl_spiral/io/toolpath_reader.h>

#include "run_program.h"
#include "two_domes.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>

namespace regions_test {

namespace {

using namespace two_domes;
using Arguments = std::vector<std::string>;

class Regions : public ::testing::Test {
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
    const Arguments own{"scan.xyz", "-o", "a.csv", "--tool-radius", "4", "--scallop", "0.05", "--threads", "2"};
    arguments.insert(arguments.begin(), own.begin(), own.end());
    return endOf(startProgram(PCL_SPIRAL_TOOLPATH_PROGRAM, arguments, folder_), folder_);
  }

  RunResult verify(const std::string& path, Arguments arguments)
  {
    const Arguments own{"scan.xyz", path, "--tool-radius", "4", "--scallop", "0.05", "-o", "v.json"};
    arguments.insert(arguments.begin(), own.begin(), own.end());
    return endOf(startProgram(PCL_SPIRAL_VERIFY_PROGRAM, arguments, folder_), folder_);
  }

  Path path(const std::string& file = "a.csv") const { return pcl_spiral::readToolpath(folder_.path(file)).path; }
  nlohmann::json json(const std::string& file) const { return nlohmann::json::parse(readText(folder_.path(file))); }

  void refuses(const Arguments& arguments, int code, const std::string& words)
  {
    const RunResult result = run(arguments);
    EXPECT_EQ(result.code, code) << result.err;
    EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
    EXPECT_FALSE(std::filesystem::exists(folder_.path("a.csv")));
  }

  ScratchFolder folder_;
};

const Arguments both{"--part-at", "-75,0,4", "--part-at", "85,10,7"};

Arguments
with(Arguments more)
{
  more.insert(more.begin(), both.begin(), both.end());
  return more;
}

} // namespace

TEST_F(Regions, TwoPartsAreCutOneAfterTheOtherAndTheLinkClearsTheScan)
{
  const std::vector<Vector3d> points = twoDomes();
  write(points);
  const RunResult result = run(with({"-o", "a.vtp", "-o", "a.json", "-o", "a.ngc", "--rapid-height", "10", "--verify"}));
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.out.find("all regions     2, 2 passes"), std::string::npos) << result.out;
  for (const char* file : {"a.csv", "a.vtp"}) {
    const Path all = path(file);
    ASSERT_EQ(pcl_spiral::passBegins(all).size(), 1U) << file;
    expectCut(passOf(all, 0), left, [](double, double) { return true; });
    expectCut(passOf(all, 1), right, [](double, double) { return true; });
  }
  const nlohmann::json report = json("a.json");
  ASSERT_EQ(report["regions"].size(), 2U);
  for (const auto& region : report["regions"])
    EXPECT_LT(region["verification"]["material"]["stock"]["uncut_share"].get<double>(), 1e-9) << region["region"];
  EXPECT_NEAR(report["path"]["length"].get<double>(),
              report["regions"][0]["path"]["length"].get<double>() + report["regions"][1]["path"]["length"].get<double>(), 1e-6);

  const auto program =
      pcl_spiral::readProgram(folder_.path("a.ngc"), pcl_spiral::readMachine(PCL_SPIRAL_MACHINES_DIR "/xyzac.yaml"), std::nullopt).program;
  std::vector<std::size_t> rapids;
  for (std::size_t i = 1; i < program.blocks.size(); ++i)
    if (program.blocks[i].rapid)
      rapids.push_back(i);
  const auto gap = std::max_element(rapids.begin() + 1, rapids.end(), [&](std::size_t a, std::size_t b) {
    return (program.blocks[a].tip - program.blocks[a - 1].tip).norm() < (program.blocks[b].tip - program.blocks[b - 1].tip).norm();
  });
  EXPECT_GT((program.blocks[*gap].tip - program.blocks[*gap - 1].tip).norm(), 80.0) << "the way from dome to dome";
  EXPECT_GT(program.blocks[*gap].tip.z(), tower_z) << "over the tower";
  for (const std::size_t rapid : rapids)
    EXPECT_LT(deepestInLinks(program, rapid, rapid + 1, points), 0.03) << "block " << rapid;
}

TEST_F(Regions, EachIsThePathOfARunOfItsOwn)
{
  write(twoDomes());
  ASSERT_EQ(run(both).code, 0);
  const Path all = path();
  for (std::size_t k = 0; k < 2; ++k) {
    ASSERT_EQ(run({"--part-at", both[2 * k + 1]}).code, 0);
    const Path one = path(), pass = passOf(all, k);
    ASSERT_EQ(one.size(), pass.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
      ASSERT_EQ(one[i].getVector3fMap(), pass[i].getVector3fMap());
      ASSERT_EQ(one[i].getAxisVector3fMap(), pass[i].getAxisVector3fMap());
      ASSERT_NEAR(one[i].arc_length, pass[i].arc_length - pass.front().arc_length, 2e-6);
    }
  }
}

TEST_F(Regions, TheJudgeCountsEachRegionOfPathAndProgram)
{
  write(twoDomes());
  ASSERT_EQ(run(with({"-o", "a.ngc"})).code, 0);
  for (const Arguments& judged : {Arguments{"a.csv"}, Arguments{"a.ngc", "--machine", PCL_SPIRAL_MACHINES_DIR "/xyzac.yaml"}}) {
    const RunResult result = verify(judged.front(), with([&] {
                                      Arguments more(judged.begin() + 1, judged.end());
                                      more.insert(more.end(), {"--max-gouge", "0.02", "--max-uncut", "0", "--max-scallop", "0.075"});
                                      return more;
                                    }()));
    EXPECT_EQ(result.code, 0) << result.err << result.out;
    const nlohmann::json figures = json("v.json");
    ASSERT_EQ(figures["paths"].size(), 2U);
    EXPECT_EQ(figures["paths"][0]["region"], "region 1 (--part-at -75,0,4)");
    EXPECT_EQ(figures["paths"][1]["region"], "region 2 (--part-at 85,10,7)");
  }
  ASSERT_EQ(run({"--part-at", "85,10,7"}).code, 0);
  const RunResult missing = verify("a.csv", both);
  EXPECT_EQ(missing.code, 1);
  EXPECT_NE(missing.err.find("region 1 (--part-at -75,0,4): a.csv: no pass of the path is on this region"), std::string::npos)
      << missing.err;
  EXPECT_EQ(verify("a.csv", {"--part-at", "85,10,7"}).code, 0);
}

TEST_F(Regions, TwoPolygonsOnOneDomeWithAKeepOut)
{
  const Dome dome{-75.0, 0.0, 36.0};
  std::vector<Vector3d> points;
  std::mt19937 random(9);
  for (int i = 0; i < 2; ++i)
    addDome(dome, random, points);
  write(points);
  writeText(folder_.path("west.txt"), "-120 -40\n-78 -40\n-78 40\n-120 40\n");
  writeText(folder_.path("east.txt"), "-72 -40\n-30 -40\n-30 40\n-72 40\n");
  writeText(folder_.path("keep.txt"), "-58 -3\n-52 -3\n-52 3\n-58 3\n");
  const Arguments halves{"--region", "east.txt", "--region", "west.txt", "--keep-out", "keep.txt", "--crop", "-120,-30,-50,50"};
  const RunResult result = run(halves);
  ASSERT_EQ(result.code, 0) << result.err;
  const Path all = path();
  ASSERT_EQ(pcl_spiral::passBegins(all).size(), 1U);
  constexpr double band = 3.0;
  const auto keep = [](double x, double y) {
    return std::hypot(std::max(std::abs(x + 55.0) - 3.0, 0.0), std::max(std::abs(y) - 3.0, 0.0));
  };
  expectCut(passOf(all, 0), dome, [&](double x, double y) { return x > -72.0 + band && keep(x, y) > radius + band + 1.0; });
  expectCut(passOf(all, 1), dome, [&](double x, double) { return x < -78.0 - band; });
  for (const Vector3d& c : centres(passOf(all, 0)))
    ASSERT_GE(keep(c.x(), c.y()), radius - 1e-4) << c.transpose();
  for (const auto& p : all)
    ASSERT_TRUE(p.x > -72.8f || p.x < -77.2f) << "between the regions: " << p.x;
  const RunResult judged = verify("a.csv", halves);
  EXPECT_EQ(judged.code, 0) << judged.err << judged.out;
}

TEST_F(Regions, AReportMakesTheSameRegionsAgain)
{
  write(twoDomes());
  ASSERT_EQ(run(with({"-o", "a.json"})).code, 0);
  const std::string bytes = readText(folder_.path("a.csv"));
  const auto replay = [&](const std::string& file) {
    return endOf(startProgram(PCL_SPIRAL_TOOLPATH_PROGRAM, {"--config", file}, folder_), folder_);
  };
  writeText(folder_.path("b.json"), readText(folder_.path("a.json")));
  std::filesystem::remove(folder_.path("a.csv"));
  ASSERT_EQ(replay("b.json").code, 0);
  EXPECT_EQ(readText(folder_.path("a.csv")), bytes);
  const std::string job = "scan: scan.xyz\ntool-radius: 4\nscallop: 0.05\noutput: [a.csv]\n";
  writeText(folder_.path("two.yaml"), job + "part-at: ['-75,0,4', '85,10,7']\n");
  ASSERT_EQ(replay("two.yaml").code, 0);
  EXPECT_EQ(readText(folder_.path("a.csv")), bytes);
  writeText(folder_.path("one.yaml"), job + "part-at: [85, 10, 7]\n");
  ASSERT_EQ(replay("one.yaml").code, 0);
  EXPECT_TRUE(pcl_spiral::passBegins(path()).empty());
}

TEST_F(Regions, ARegionThatFailsIsNamedAndNothingIsWritten)
{
  write(twoDomes());
  std::ostringstream round;
  for (int i = 0; i < 24; ++i)
    round << left.x + 24.2 * std::cos(M_PI * i / 12.0) << ' ' << left.y + 24.2 * std::sin(M_PI * i / 12.0) << '\n';
  writeText(folder_.path("left.txt"), round.str());
  writeText(folder_.path("all.txt"), "-139 -69\n139 -69\n139 69\n-139 69\n");
  writeText(folder_.path("far.txt"), "500 500\n600 500\n600 600\n");
  refuses({"--region", "left.txt", "--region", "far.txt", "--part-at", "-75,0,4"}, 2,
          "scan.xyz: region 2 (--region far.txt): no point is left");
  refuses({"--part-at", "-75,0,4", "--part-at", "85,10,60"}, 2, "scan.xyz: region 2 (--part-at 85,10,60): ");
  refuses({"--part-at", "-75,0,4", "--part-at", "-70,3,4"}, 1, "region 1 (--part-at -75,0,4) and region 2 (--part-at -70,3,4) have ");
  refuses({"--region", "left.txt", "--part-at", "85,10,7"}, 2, "--part-at 85,10,7: this place is in no --region");
  refuses(with({"--center", "0,0,0"}), 2, "--center belongs to one region");
  EXPECT_EQ(run(with({"-o", "a.apt"})).code, 0) << "its passes are the regions";
  EXPECT_EQ(run({"--region", "left.txt", "--part-at", "-75,0,4"}).code, 0);
  const RunResult in_one = run(with({"--region", "all.txt"}));
  EXPECT_EQ(in_one.code, 0) << in_one.err;
  EXPECT_EQ(pcl_spiral::passBegins(path()).size(), 1U);
}

TEST_F(Regions, ALinkThatWouldTouchTheScanIsRefusedWithoutAProgramToo)
{
  std::vector<Vector3d> points = twoDomes();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  write(points);
  ASSERT_EQ(run(both).code, 0);
  const auto last = passOf(path(), 0).back();
  const Vector3d over =
      (last.getVector3fMap() + radius * last.getNormalVector3fMap()).cast<double>() +
      70.0 * last.getAxisVector3fMap().cast<double>(); // a beam over the end of the first pass, beyond what the shank reaches
  for (int i = 0; i < 600; ++i)
    points.push_back(over + Vector3d(6.0 * unit(random), 6.0 * unit(random), 0.1 * unit(random)));
  write(points);
  std::filesystem::remove(folder_.path("a.csv"));
  refuses(both, 1, "on its way up from the path");
  const RunResult accepted = run(with({"--accept-collisions"}));
  EXPECT_EQ(accepted.code, 0) << accepted.err;
  EXPECT_NE(accepted.err.find("on its way up from the path"), std::string::npos) << accepted.err;
}

} // namespace regions_test
