// SPDX-License-Identifier: BSD-3-Clause
// Scans in map coordinates from outside: the paths of all programs are those of the same part near 0, files and places are in the
// coordinates of the scan, and pcl_spiral_verify needs no option for them.
#include "command_line/cap_scan.h"
#include "command_line/run_program.h"
#include "support/ridges.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace shifted_scan_test {

namespace {

using Arguments = std::vector<std::string>;
using Eigen::Vector3d;
using Places = std::vector<Vector3d>;

const Vector3d place(393775400.0, 3689071200.0, 3107003.0); ///< mm; x 393775.4 m, y 3689071.2 m
constexpr double survey_foot = 1200000.0 / 3937.0;          ///< mm
const Arguments cutter{"--tool-radius", "5", "--scallop", "0.1"};

Arguments
operator+(Arguments a, const Arguments& b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/** Points that lie round 0, as text round the place in the unit. */
std::string
onMap(const std::string& points, double unit)
{
  std::istringstream in(points);
  std::ostringstream out;
  out << std::fixed << std::setprecision(10);
  for (Vector3d p; in >> p.x() >> p.y() >> p.z();) {
    p = (p + place) / unit;
    out << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  }
  return out.str();
}

/** Contacts of a toolpath CSV, less \p origin, in double precision. */
Places
contacts(const std::string& csv, const Vector3d& origin)
{
  std::istringstream in(csv);
  Places places;
  std::string line;
  for (std::getline(in, line); std::getline(in, line);) {
    std::vector<double> row;
    std::istringstream words(line);
    for (std::string word; std::getline(words, word, ',');)
      row.push_back(std::stod(word));
    places.push_back(Vector3d(row.at(2), row.at(3), row.at(4)) - origin);
  }
  return places;
}

/** Largest distance of a contact of \p a from the moves of \p b. */
double
distance(const Places& a, const Places& b)
{
  double largest = 0.0;
  for (const Vector3d& p : a) {
    double nearest = 1e9;
    for (std::size_t i = 0; i + 1 < b.size(); ++i) {
      const Vector3d move = b[i + 1] - b[i];
      const double t = move.isZero() ? 0.0 : std::clamp((p - b[i]).dot(move) / move.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (b[i] + t * move - p).squaredNorm());
    }
    largest = std::max(largest, std::sqrt(nearest));
  }
  return largest;
}

class ShiftedScan : public ::testing::Test {
protected:
  ShiftedScan()
  {
    writeText(folder_.path("near.xyz"), capScan(3000));
    writeText(folder_.path("map.xyz"), onMap(capScan(3000), 1000.0));
  }

  RunResult run(const std::string& program, const Arguments& arguments)
  {
    return endOf(startProgram(program, arguments, folder_), folder_);
  }
  RunResult toolpath(const Arguments& arguments) { return run(PCL_SPIRAL_TOOLPATH_PROGRAM, arguments + cutter); }

  /** Expects that both files are the same path. */
  void expectSame(const std::string& map, const std::string& near)
  {
    const Places a = contacts(readText(folder_.path(map)), place), b = contacts(readText(folder_.path(near)), Vector3d::Zero());
    ASSERT_GT(b.size(), 10U);
    EXPECT_LE(distance(a, b), 1e-3);
    EXPECT_LE(distance(b, a), 1e-3);
  }

  void expectHas(const std::string& text, const std::string& part)
  {
    EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' in: " << text;
  }

  void expectHasNot(const std::string& text, const std::string& part)
  {
    EXPECT_EQ(text.find(part), std::string::npos) << "'" << part << "' in: " << text;
  }

  nlohmann::json json(const std::string& file) { return nlohmann::json::parse(readText(folder_.path(file))); }

  ScratchFolder folder_;
};

} // namespace

TEST_F(ShiftedScan, PathIsThatOfTheSamePartNearZero)
{
  writeText(folder_.path("feet.pts"), "3000\n" + onMap(capScan(3000), survey_foot));
  const RunResult made = toolpath({"map.xyz", "--units", "m", "--method", "radial", "-o", "map.csv"});
  ASSERT_EQ(made.code, 0) << made.err;
  EXPECT_TRUE(made.err.empty()) << made.err;
  expectHas(made.out, "shift           map coordinates less 393775400, 3689071200, 3107000 mm");
  ASSERT_EQ(toolpath({"near.xyz", "--method", "radial", "-o", "near.csv"}).code, 0);
  ASSERT_EQ(toolpath({"feet.pts", "--units", "us-ft", "--method", "radial", "-o", "feet.csv"}).code, 0);
  expectSame("map.csv", "near.csv");
  expectSame("feet.csv", "near.csv");
}

TEST_F(ShiftedScan, ScriptsFindPlacesAndOptionsOfWhatIsSaid)
{
  ASSERT_EQ(toolpath({"map.xyz", "--units", "m", "-o", "p.csv"}).code, 0);
  const RunResult judged =
      run(PCL_SPIRAL_VERIFY_PROGRAM, Arguments{"map.xyz", "p.csv", "--units", "m", "--max-deviation", "1e-7", "-o", "v.json"} + cutter);
  EXPECT_EQ(judged.code, 1);
  const nlohmann::json path = json("v.json").at("paths").at(0), said = path.at("diagnostics").at("broken_limits").at(0);
  EXPECT_EQ(said.at("text"), path.at("broken_limits").at(0));
  EXPECT_EQ(said.at("settings"), nlohmann::json({"Limits::deviation"}));
  expectHas(said.at("text"), "--max-deviation 1e-07 is broken");
  EXPECT_EQ(said.at("id").get<std::string>().find("{Limits::deviation} {number} is broken: {number} {mm}"), 0U) << said;
  EXPECT_EQ(said.at("numbers").at(0), 1e-7);
  const nlohmann::json worst = path.at("deviation").at("max"), at = said.at("places").at(0);
  EXPECT_EQ(said.at("numbers").at(2), worst.at("index"));
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(at.at(c).get<double>(), worst.at("position").at(c).get<double>(), 1e-6); // in the coordinates of the scan
  EXPECT_NEAR(at.at(0).get<double>(), place.x(), 1000.0);
  expectHas(said.at("text"), "(in the file 39377");
}

TEST_F(ShiftedScan, VerifyNeedsNoOption)
{
  ASSERT_EQ(toolpath({"map.xyz", "--units", "m", "-o", "p.csv", "-o", "p.pcd", "-o", "p.ply", "-o", "p.vtp"}).code, 0);
  const Arguments limits{"--units", "m", "--max-deviation", "0.001", "--max-gouge", "0.03", "--max-uncut", "0"};
  for (const std::string file : {"p.csv", "p.pcd", "p.ply", "p.vtp"}) {
    const RunResult judged = run(PCL_SPIRAL_VERIFY_PROGRAM, Arguments{"map.xyz", file, "-o", "v.json", "-o", "v.vtp"} + limits + cutter);
    EXPECT_EQ(judged.code, 0) << file << judged.out << judged.err;
    const auto position = json("v.json")["paths"][0]["deviation"]["max"]["position"];
    EXPECT_NEAR(position[0].get<double>(), place.x(), 50.0) << file;
    EXPECT_NEAR(position[1].get<double>(), place.y(), 50.0) << file;
  }
  ASSERT_EQ(run(PCL_SPIRAL_VERIFY_PROGRAM, Arguments{"map.xyz", "v.vtp"} + limits + cutter).code, 0) << "what it writes is as consistent";
  writeText(folder_.path("moved.xyz"), onMap(capScan(3000), 1000.0 * (1.0 + 3e-12))); // by 0.01 mm in y
  const RunResult broken = run(PCL_SPIRAL_VERIFY_PROGRAM, Arguments{"moved.xyz", "p.csv"} + limits + cutter);
  EXPECT_EQ(broken.code, 1) << "a hundredth of a millimetre shows";
}

TEST_F(ShiftedScan, PlacesOfOptionsAndReportsAreThoseOfTheScan)
{
  const RunResult made = toolpath({"map.xyz",
                                   "--units",
                                   "m",
                                   "--method",
                                   "radial",
                                   "--center",
                                   "393775405,3689071195,3107003",
                                   "--start",
                                   "393775440,3689071200,3106995",
                                   "--view-point",
                                   "393775400,3689071200,3109000",
                                   "--machine",
                                   PCL_SPIRAL_MACHINES_DIR "/xyzac.yaml",
                                   "-o",
                                   "map.csv",
                                   "-o",
                                   "map.json",
                                   "-o",
                                   "map.html",
                                   "-o",
                                   "map.ngc"});
  ASSERT_EQ(made.code, 0) << made.err;
  const nlohmann::json report = json("map.json");
  EXPECT_EQ(report["input"]["shift"], (nlohmann::json{393775400.0, 3689071200.0, 3107000.0}));
  EXPECT_EQ(report["settings"]["center"], (nlohmann::json{393775405.0, 3689071195.0, 3107003.0}));
  EXPECT_NEAR(report["path"]["center"][0].get<double>(), 393775405.0, 0.1);
  EXPECT_NEAR(report["path"]["center"][1].get<double>(), 3689071195.0, 0.1);
  expectHas(readText(folder_.path("map.html")), "393775400.000, 3689071200.000, 3107000.000 mm subtracted");
  const Places path = contacts(readText(folder_.path("map.csv")), place);
  EXPECT_LE((path.front() - Vector3d(5.0, -5.0, 0.0)).norm(), 0.5) << "begins at the centre that was given";
  const std::string program = readText(folder_.path("map.ngc"));
  expectHas(program, "map.xyz, coordinates less 393775400, 3689071200, 3107000 mm");
  expectHasNot(program, "X3937");
}

TEST_F(ShiftedScan, ViewPointOfTheScansCoordinatesDecidesTheSide)
{
  const Arguments job{"map.xyz", "--units", "m", "--method", "radial", "-o", "map.csv", "--view-point"};
  ASSERT_EQ(toolpath(job + Arguments{"393775400,3689071200,3106000"}).code, 0); // from below
  expectHas(run(PCL_SPIRAL_VERIFY_PROGRAM, Arguments{"map.xyz", "map.csv", "--units", "m"} + cutter).out, "turned normals");
  EXPECT_EQ(
      run(PCL_SPIRAL_VERIFY_PROGRAM,
          Arguments{"map.xyz", "map.csv", "--units", "m", "--view-point", "393775400,3689071200,3106000", "--max-gouge", "0.03"} + cutter)
          .code,
      0);
}

TEST_F(ShiftedScan, MessagesNameThePlacesOfTheScan)
{
  std::istringstream first(capScan(3000));
  std::ostringstream two;
  for (Vector3d p; first >> p.x() >> p.y() >> p.z();)
    two << p.transpose() << '\n' << (p + Vector3d(500.0, 0.0, 0.0)).transpose() << '\n';
  writeText(folder_.path("two.xyz"), onMap(two.str(), 1000.0));
  const RunResult refused = toolpath({"two.xyz", "--units", "m", "-o", "two.csv"});
  EXPECT_EQ(refused.code, 1);
  expectHas(refused.err, "2 separate parts");
  expectHas(refused.err, "(393775400."); // the middle of each
  expectHas(refused.err, "(393775900.");
  expectHas(refused.err, "in the file 393775.4");
}

TEST_F(ShiftedScan, WrongUnitIsNamedAndTheRemedyWorks)
{
  const RunResult wrong = toolpath({"map.xyz", "-o", "map.csv"});
  EXPECT_EQ(wrong.code, 1);
  expectHas(wrong.err, "map coordinates are usually in metres or feet");
  expectHas(wrong.err, "--units m");
  expectHasNot(wrong.err, "metres or inches");
  EXPECT_EQ(toolpath({"map.xyz", "--units", "m", "-o", "map.csv"}).code, 0);
}

TEST_F(ShiftedScan, ABallLargerThanThePartNeedsTheUnit)
{
  std::istringstream cap(capScan(2000));
  std::ostringstream lens; // 8 mm across, of radius 10 mm
  for (Vector3d p; cap >> p.x() >> p.y() >> p.z();)
    lens << (0.1 * p).transpose() << '\n';
  writeText(folder_.path("lens.xyz"), lens.str());
  const Arguments asked{"lens.xyz", "--tool-radius", "20", "--scallop", "0.1", "-o", "lens.csv"};
  const RunResult wrong = endOf(startProgram(PCL_SPIRAL_TOOLPATH_PROGRAM, asked, folder_), folder_);
  EXPECT_EQ(wrong.code, 1);
  expectHas(wrong.err, "is the scan in metres or inches?");
  expectHas(wrong.err, "--units mm if the ball is larger than the part");
  Arguments given = asked;
  given.insert(given.end(), {"--units", "mm"});
  const RunResult right = endOf(startProgram(PCL_SPIRAL_TOOLPATH_PROGRAM, given, folder_), folder_);
  EXPECT_EQ(right.code, 0) << right.err;
  expectHas(right.err, "less than the tool radius 20 mm");
}

TEST_F(ShiftedScan, OriginIsSubtractedAsBefore)
{
  const Arguments job{"map.xyz", "--units", "m", "--method", "radial", "-o", "map.csv", "--origin"};
  const RunResult given = toolpath(job + Arguments{"393775,3689071,3107"});
  ASSERT_EQ(given.code, 0) << given.err;
  expectHas(given.out, "the path is relative to 393775, 3689071, 3107 in the scan's unit");
  expectHasNot(given.out, "shift  ");
  EXPECT_LE((contacts(readText(folder_.path("map.csv")), Vector3d(400.0, 200.0, 3.0)).front()).norm(), 1.0);
  EXPECT_EQ(run(PCL_SPIRAL_VERIFY_PROGRAM,
                Arguments{"map.xyz", "map.csv", "--units", "m", "--origin", "393775,3689071,3107", "--max-deviation", "0.001"} + cutter)
                .code,
            0);
  const RunResult none = toolpath(job + Arguments{"0,0,0"});
  EXPECT_NE(none.code, 0) << "rounded to 0.25 m";
}

TEST_F(ShiftedScan, DrivePassesAreThoseOfTheSamePartNearZero)
{
  std::ostringstream curve;
  for (int i = -30; i <= 30; ++i)
    curve << i << ' ' << 0.3 * i << " 0\n";
  writeText(folder_.path("near.txt"), curve.str());
  writeText(folder_.path("map.txt"), onMap(curve.str(), 1000.0));
  const auto drive = [&](const std::string& scan, const Arguments& more) {
    const RunResult made = run(PCL_SPIRAL_DRIVE_PROGRAM, Arguments{scan + ".xyz", "--tool-radius", "3", "-o", scan + ".csv"} + more);
    ASSERT_EQ(made.code, 0) << made.err;
  };
  drive("near", {"--step-over", "8"});
  drive("map", {"--step-over", "8", "--units", "m"});
  expectSame("map.csv", "near.csv");
  drive("near", {"--drive", "curve", "--curve", "near.txt"});
  drive("map", {"--drive", "curve", "--curve", "map.txt", "--units", "m"});
  expectSame("map.csv", "near.csv");
}

TEST_F(ShiftedScan, RidgeRowsAreThoseOfTheSameLinesNearZero)
{
  const pcl_spiral::test::ExactRidge die = pcl_spiral::test::dieRidge();
  const auto lines = [&](const Places& points, const std::string& name) {
    std::ostringstream text;
    text << std::setprecision(9);
    for (const Vector3d& p : points)
      text << p.transpose() << '\n';
    writeText(folder_.path("near_" + name), text.str());
    writeText(folder_.path("map_" + name), onMap(text.str(), 1000.0));
  };
  lines(die.railPoints(300), "rail.txt");
  lines(die.generatorPoints(0.37, 100), "generator.txt");
  const Arguments rows{"--spot", "9", "--point-spacing", "5"};
  const auto ridge = [&](const std::string& kind, const Arguments& more) {
    return run(PCL_SPIRAL_RIDGE_PROGRAM, Arguments{kind + "_rail.txt", kind + "_generator.txt", "-o", kind + ".csv"} + rows + more);
  };
  ASSERT_EQ(ridge("near", {}).code, 0);
  const RunResult made = ridge("map", {"--units", "m"});
  ASSERT_EQ(made.code, 0) << made.err;
  expectHas(made.out, "map coordinates less");
  expectHas(made.out, "meets the rail at (3937");
  expectSame("map.csv", "near.csv");
}

} // namespace shifted_scan_test
