// SPDX-License-Identifier: BSD-3-Clause
// Paths of other cutters than a ball, judged by pcl_spiral_verify: as contacts, as tips and axes, in passes, and as programs.
#include "cap_scan.h"
#include "run_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <iomanip>
#include <memory>
#include <sstream>

namespace judged_cutter_test {

namespace {

using Arguments = std::vector<std::string>;

const std::string machines = PCL_SPIRAL_MACHINES_DIR;
const Arguments bull_nose{"--tool-radius", "3", "--corner-radius", "1"};

Arguments
operator+(Arguments a, const Arguments& b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

std::vector<std::string>
fieldsOf(const std::string& line)
{
  std::istringstream stream(line);
  std::vector<std::string> fields;
  for (std::string field; std::getline(stream, field, ',');)
    fields.push_back(field);
  return fields;
}

class JudgedCutter : public ::testing::Test {
protected:
  /** The scan and rows of a bull-nose over it, made once. */
  static void SetUpTestSuite()
  {
    made_ = std::make_unique<ScratchFolder>();
    writeText(made_->path("cap.xyz"), capScan(5000));
    const RunResult result = endOf(startProgram(PCL_SPIRAL_DRIVE_PROGRAM,
                                                Arguments{"cap.xyz"} + bull_nose +
                                                    Arguments{"--step-over", "0.8", "--tolerance", "0.005", "-o", "rows.csv", "-o",
                                                              "rows.vtp", "-o", "rows.ngc", "--machine", machines + "/xyzac.yaml"},
                                                *made_),
                                   *made_);
    ASSERT_EQ(result.code, 0) << result.err;
  }
  static void TearDownTestSuite() { made_.reset(); }
  void SetUp() override { std::filesystem::copy(made_->root(), folder_.root()); }

  RunResult verify(const std::string& file, const Arguments& more)
  {
    return endOf(startProgram(PCL_SPIRAL_VERIFY_PROGRAM,
                              Arguments{"cap.xyz", file, "--scallop", "0.05", "--chord-error", "0.005", "-o", "out.json"} + more, folder_),
                 folder_);
  }

  nlohmann::json figures() { return nlohmann::json::parse(readText(folder_.path("out.json")))["paths"][0]; }

  /** Only tips and axes of rows.csv, and the row as pass; those of the rows from \p first to \p last lowered. */
  void writeTips(const std::string& file, double lowered, std::size_t first, std::size_t last)
  {
    std::istringstream rows(readText(folder_.path("rows.csv")));
    std::ostringstream tips;
    tips << std::fixed << std::setprecision(6) << "x,y,z,i,j,k,pass\n";
    std::string line;
    std::getline(rows, line);
    for (std::size_t i = 0; std::getline(rows, line); ++i) {
      const std::vector<std::string> f = fieldsOf(line);
      tips << f[8] << ',' << f[9] << ',' << std::stod(f[10]) - (i >= first && i <= last ? lowered : 0.0) << ',' << f[11] << ',' << f[12]
           << ',' << f[13] << ',' << f[0] << '\n';
    }
    writeText(folder_.path(file), tips.str());
  }

  static inline std::unique_ptr<ScratchFolder> made_;
  ScratchFolder folder_;
};

const Arguments sound{"--max-gouge", "0.008", "--max-deviation", "0.012", "--max-uncut", "0"};

} // namespace

TEST_F(JudgedCutter, EveryFileOfTheRowsKeepsTheLimits)
{
  writeTips("tips.csv", 0.0, 0, 0);
  double lifts = 0.0;
  for (const Arguments& file : {Arguments{"rows.csv"}, Arguments{"rows.vtp"}, Arguments{"tips.csv"},
                                Arguments{"rows.ngc", "--machine", machines + "/xyzac.yaml"}}) {
    const RunResult result = verify(file[0], Arguments(file.begin() + 1, file.end()) + bull_nose + sound);
    EXPECT_EQ(result.code, 0) << file[0] << result.out << result.err;
    const nlohmann::json json = figures();
    EXPECT_GT(json["motion"]["lifts"].get<double>(), 10) << file[0];
    EXPECT_LT(json["material"]["stock"]["max"]["value"].get<double>(), 0.2);
    lifts = lifts > 0.0 ? lifts : json["motion"]["lifts"].get<double>();
    EXPECT_EQ(json["motion"]["lifts"].get<double>(), lifts) << file[0]; // the way between rows is no cut
  }
}

TEST_F(JudgedCutter, ALoweredTipIsFoundByItsDepth)
{
  writeTips("tips.csv", 0.2, 400, 402);
  const RunResult result = verify("tips.csv", bull_nose + sound);
  EXPECT_EQ(result.code, 1);
  EXPECT_NE(result.out.find("gouge"), std::string::npos);
  const nlohmann::json gouge = figures()["material"]["gouge"];
  const double from_top = std::hypot(gouge["position"][0].get<double>(), gouge["position"][1].get<double>());
  const double upright = std::sqrt(1.0 - from_top * from_top / 1e4); // of the sphere's normal
  EXPECT_NEAR(gouge["value"].get<double>(), 0.2 * upright, 0.002);
  const auto index = gouge["index"].get<long>();
  EXPECT_TRUE(index >= 399 && index <= 403) << index;
}

TEST_F(JudgedCutter, AnotherCutterThanThatOfThePathIsSaid)
{
  const RunResult ball = verify("rows.csv", {"--tool-radius", "3", "--max-gouge", "0.008"});
  EXPECT_EQ(ball.code, 1);
  EXPECT_NE(ball.err.find("tool tips"), std::string::npos) << ball.err;
  const RunResult wide = verify("rows.csv", {"--tool-radius", "4", "--corner-radius", "1", "--max-gouge", "0.008"});
  EXPECT_EQ(wide.code, 1);
  EXPECT_NE(wide.err.find("--corner-radius"), std::string::npos) << wide.err;
  const RunResult none = verify("rows.csv", {"--corner-radius", "1"});
  EXPECT_EQ(none.code, 2);
  const RunResult impossible = verify("rows.csv", {"--tool-radius", "3", "--corner-radius", "4"});
  EXPECT_EQ(impossible.code, 2);
  EXPECT_NE(impossible.err.find("--corner-radius"), std::string::npos);
}

TEST_F(JudgedCutter, TipsOfABallAreEnoughToo)
{
  const RunResult made =
      endOf(startProgram(PCL_SPIRAL_TOOLPATH_PROGRAM,
                         {"cap.xyz", "--tool-radius", "3", "--scallop", "0.05", "--tilt", "10", "-o", "rows.csv"}, folder_),
            folder_);
  ASSERT_EQ(made.code, 0) << made.err;
  std::istringstream rows(readText(folder_.path("rows.csv")));
  std::ostringstream tips;
  std::string line;
  std::getline(rows, line);
  while (std::getline(rows, line)) {
    const std::vector<std::string> f = fieldsOf(line);
    tips << f[8] << ',' << f[9] << ',' << f[10] << ',' << f[11] << ',' << f[12] << ',' << f[13] << '\n';
  }
  writeText(folder_.path("tips.csv"), tips.str()); // without a header: x, y, z, i, j, k
  const RunResult result = verify("tips.csv", {"--tool-radius", "3", "--max-gouge", "0.008", "--max-scallop", "0.06", "--max-uncut", "0"});
  EXPECT_EQ(result.code, 0) << result.out << result.err;
}

TEST_F(JudgedCutter, TheSurfaceAfterCuttingIsWritten)
{
  const RunResult result = verify("rows.csv", bull_nose + Arguments{"--stock", "left.ply", "--stock", "left.stl"});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_NE(readText(folder_.path("left.ply")).find("property float stock"), std::string::npos);
  EXPECT_GT(readText(folder_.path("left.stl")).size(), 50u * 5000u);
  const RunResult kind = verify("rows.csv", bull_nose + Arguments{"--stock", "left.txt"});
  EXPECT_EQ(kind.code, 2);
  EXPECT_NE(kind.err.find("left.ply"), std::string::npos) << kind.err;
  const RunResult two = verify("rows.csv", bull_nose + Arguments{"rows.vtp", "--stock", "left.ply"});
  EXPECT_EQ(two.code, 2);
  EXPECT_NE(two.err.find("only one path"), std::string::npos) << two.err;
  const RunResult input = verify("rows.csv", bull_nose + Arguments{"--stock", "left.ply", "-o", "left.ply"});
  EXPECT_EQ(input.code, 2);
  const RunResult made =
      endOf(startProgram(PCL_SPIRAL_TOOLPATH_PROGRAM,
                         {"cap.xyz", "--tool-radius", "3", "--scallop", "0.05", "-o", "path.csv", "--stock", "path_left.ply"}, folder_),
            folder_);
  EXPECT_EQ(made.code, 0) << made.err;
  EXPECT_NE(readText(folder_.path("path_left.ply")).find("property float stock"), std::string::npos);
}

} // namespace judged_cutter_test
