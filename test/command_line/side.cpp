// SPDX-License-Identifier: BSD-3-Clause
// The side of the cutter, from outside: +z, view points, normals and VIEWPOINT of files, on a jug whose sides are known.
#include "cap_scan.h"
#include "run_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <iomanip>
#include <sstream>

namespace side_test {

namespace {

using Arguments = std::vector<std::string>;

struct JugPoint {
  double x, y, z, nx, ny, nz; ///< the normal points out of the jug
};

/** A jug about z that widens upwards, 60 mm high, over \p turn of its circumference: the outer normals have z = -0.316. */
std::vector<JugPoint>
jug(double turn = 1.0)
{
  std::vector<JugPoint> points;
  const double length = std::sqrt(1.0 + 9.0), across = 3.0 / length, up = -1.0 / length;
  for (int row = 0; row <= 30; ++row)
    for (int i = 0; i < static_cast<int>(160 * turn); ++i) {
      const double z = 2.0 * row, r = 40.0 + z / 3.0, angle = 2.0 * M_PI * (i + 0.5 * (row % 2)) / 160.0;
      points.push_back({r * std::cos(angle), r * std::sin(angle), z, across * std::cos(angle), across * std::sin(angle), up});
    }
  return points;
}

/** The points as text, with normals times \p sign; 0: without normals. */
std::string
rowsOf(const std::vector<JugPoint>& points, int sign)
{
  std::ostringstream text;
  text << std::setprecision(9);
  for (const JugPoint& p : points) {
    text << p.x << ' ' << p.y << ' ' << p.z;
    if (sign != 0)
      text << ' ' << sign * p.nx << ' ' << sign * p.ny << ' ' << sign * p.nz;
    text << '\n';
  }
  return text.str();
}

std::string
pcd(const std::vector<JugPoint>& points, const std::string& view_point, int sign = 0)
{
  const std::string count = std::to_string(points.size()), n = sign != 0 ? " normal_x normal_y normal_z" : "";
  const auto repeat = [&](const std::string& word) { return sign != 0 ? word + word + word + word + word + word : word + word + word; };
  return "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z" + n + "\nSIZE" + repeat(" 4") + "\nTYPE" + repeat(" F") + "\nCOUNT" + repeat(" 1") +
         "\nWIDTH " + count + "\nHEIGHT 1\nVIEWPOINT " + view_point + "\nPOINTS " + count + "\nDATA ascii\n" + rowsOf(points, sign);
}

std::string
ply(const std::vector<JugPoint>& points, int sign)
{
  std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(points.size()) + "\n";
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz"})
    text += std::string("property float ") + name + "\n";
  return text + "end_header\n" + rowsOf(points, sign);
}

class Side : public ::testing::Test {
protected:
  /** Plans a path on \p scan. \return the share of its contacts whose normal points away from the axis of the jug */
  double outside(const std::string& scan, Arguments arguments = {})
  {
    arguments.insert(arguments.begin(),
                     {scan, "--tool-radius", "3", "--scallop", "0.2", "-o", "path.csv", "-o", "path.json", "-o", "path.html"});
    run_ = endOf(startProgram(PCL_SPIRAL_TOOLPATH_PROGRAM, arguments, folder_), folder_);
    EXPECT_EQ(run_.code, 0) << run_.err;
    report_ = nlohmann::json::parse(readText(folder_.path("path.json")), nullptr, false);
    std::istringstream in(readText(folder_.path("path.csv")));
    std::string line;
    std::size_t out = 0, all = 0;
    for (std::getline(in, line); std::getline(in, line); ++all) {
      std::istringstream words(line);
      std::vector<double> row;
      for (std::string word; std::getline(words, word, ',');)
        row.push_back(std::stod(word));
      out += row.at(2) * row.at(5) + row.at(3) * row.at(6) > 0.0;
    }
    EXPECT_GT(all, 100u);
    return static_cast<double>(out) / static_cast<double>(all);
  }
  void write(const std::string& name, const std::string& text) { writeText(folder_.path(name), text); }
  void expectSide(const std::string& text) const
  {
    EXPECT_NE(run_.out.find("side            " + text), std::string::npos) << "'" << text << "' in " << run_.out;
  }
  void expectWarning(const std::string& text) const
  {
    EXPECT_NE(run_.err.find(text), std::string::npos) << "'" << text << "' in " << run_.err;
  }

  ScratchFolder folder_;
  RunResult run_;
  nlohmann::json report_;
};

TEST_F(Side, AWeakVoteOfZIsReportedAndItsRemediesWork)
{
  write("jug.xyz", rowsOf(jug(), 0));
  EXPECT_EQ(outside("jug.xyz"), 0.0);
  expectSide("by +z: mean cosine 0.31");
  expectWarning("the outer side was taken from +z, but this is not clear: the mean cosine between the normals and +z is 0.31");
  expectWarning("the hollow side");
  expectWarning("--view-point");
  expectWarning("--flip-normals");
  EXPECT_NE(readText(folder_.path("path.html")).find("mean cosine 0.31"), std::string::npos);
  const nlohmann::json side = report_.at("surface").at("side");
  EXPECT_EQ(side.at("vote"), "+z");
  EXPECT_NEAR(side.at("mean_cosine"), 0.316, 0.01);
  EXPECT_EQ(side.at("agreement"), 1.0);
  EXPECT_LT(side.at("convex_cosine"), -0.8);

  EXPECT_EQ(outside("jug.xyz", {"--flip-normals"}), 1.0);
  expectSide("by +z: mean cosine 0.31");
  expectSide("by +z: mean cosine 0.316, 100 % of the area agrees; turned to the other side on request, the convex side");
  EXPECT_EQ(run_.err.find("side"), std::string::npos) << run_.err;
}

TEST_F(Side, AClearSideIsNotWarnedOf)
{
  write("cap.xyz", capScan(4000));
  outside("cap.xyz");
  expectSide("by +z: mean cosine 0.9");
  EXPECT_EQ(run_.err.find("side"), std::string::npos) << run_.err;
}

TEST_F(Side, ViewPointOfAPCDFileDecides)
{
  write("within.pcd", pcd(jug(), "0 0 30 1 0 0 0"));
  EXPECT_EQ(outside("within.pcd"), 0.0);
  expectSide("by the view point: mean cosine");
  expectSide(report_.at("surface").at("side").at("vote") == "view point" ? "by" : "the vote of the report");
  EXPECT_NE(run_.out.find("(VIEWPOINT of the file; --view-point overrides it)"), std::string::npos) << run_.out;
  EXPECT_EQ(report_.at("settings").at("view_point"), nlohmann::json({0.0, 0.0, 30.0}));
  expectWarning("the surface surrounds the view point by more than three quarters of a turn, so the inner side was taken");

  write("front.pcd", pcd(jug(0.25), "250 250 -60 1 0 0 0"));
  EXPECT_EQ(outside("front.pcd"), 1.0);
  EXPECT_EQ(run_.err.find("side"), std::string::npos) << run_.err;
  EXPECT_EQ(outside("front.pcd", {"--view-point", "0,0,80"}), 0.0);
  EXPECT_EQ(run_.out.find("VIEWPOINT"), std::string::npos) << run_.out;
  EXPECT_EQ(outside("front.pcd", {"--flip-normals"}), 0.0);

  write("default.pcd", pcd(jug(), "0 0 0 1 0 0 0"));
  EXPECT_EQ(outside("default.pcd"), 0.0);
  expectSide("by +z");
}

TEST_F(Side, ViewPointIsInTheUnitAndOriginOfTheFile)
{
  write("front.pcd", pcd(jug(0.25), "250 250 -60 1 0 0 0"));
  EXPECT_EQ(outside("front.pcd", {"--origin", "10,20,30"}), 1.0);
  EXPECT_EQ(report_.at("settings").at("view_point"), nlohmann::json({240.0, 230.0, -90.0}));
}

TEST_F(Side, AViewPointThatMuchOfTheSurfaceFacesAwayFromIsReported)
{
  write("jug.xyz", rowsOf(jug(), 0));
  outside("jug.xyz", {"--view-point", "300,0,30"});
  expectSide("by the view point: mean cosine");
  expectWarning("of the area faces away from the view point, but a scanner sees only what faces it");
  expectWarning("--flip-normals");
}

TEST_F(Side, NormalsOfTheFileDecideAndOptionsOverrideThem)
{
  const std::string named = "x y z nx ny nz\n";
  for (const int sign : {1, -1}) {
    write("jug.ply", ply(jug(), sign));
    write("jug.pcd", pcd(jug(), "0 0 30 1 0 0 0", sign));
    write("jug.txt", named + rowsOf(jug(), sign));
    for (const char* file : {"jug.ply", "jug.pcd", "jug.txt"}) {
      EXPECT_EQ(outside(file), sign > 0 ? 1.0 : 0.0) << file;
      expectSide("by the given normals: 100 % of the area agrees");
      EXPECT_NE(run_.out.find("(normals of the file; --view-point overrides them)"), std::string::npos) << run_.out;
      EXPECT_EQ(run_.err.find("side"), std::string::npos) << run_.err;
    }
  }
  EXPECT_EQ(outside("jug.ply", {"--flip-normals"}), 1.0);
  write("jug.ply", ply(jug(), 1));
  EXPECT_EQ(outside("jug.ply", {"--view-point", "0,0,30"}), 0.0);
  expectSide("by the view point");
}

TEST_F(Side, NormalsDoNotChangeThePathButForItsSide)
{
  write("jug.txt", "x y z nx ny nz\n" + rowsOf(jug(), -1));
  write("jug.xyz", rowsOf(jug(), 0));
  outside("jug.xyz");
  const std::string plain = readText(folder_.path("path.csv"));
  outside("jug.txt");
  EXPECT_EQ(readText(folder_.path("path.csv")), plain);
}

TEST_F(Side, NormalsWithoutACommonSideAreNotUsed)
{
  std::vector<JugPoint> points = jug();
  for (std::size_t i = 0; i < points.size(); i += 3)
    points[i] = {points[i].x, points[i].y, points[i].z, -points[i].nx, -points[i].ny, -points[i].nz};
  write("jug.ply", ply(points, 1));
  EXPECT_EQ(outside("jug.ply"), 0.0);
  expectSide("by +z");
  expectWarning("the given normals have no common side and were not used: they agree on 66");
}

TEST_F(Side, TheJudgeUsesTheSameRule)
{
  write("jug.ply", ply(jug(), 1));
  EXPECT_EQ(outside("jug.ply"), 1.0);
  const RunResult judged =
      endOf(startProgram(PCL_SPIRAL_VERIFY_PROGRAM, {"jug.ply", "path.csv", "--tool-radius", "3", "--scallop", "0.2", "-o", "judged.json"},
                         folder_),
            folder_);
  EXPECT_EQ(judged.code, 0) << judged.err;
  EXPECT_NE(judged.out.find("side            by the given normals"), std::string::npos) << judged.out;
  const nlohmann::json path = nlohmann::json::parse(readText(folder_.path("judged.json"))).at("paths").at(0);
  EXPECT_EQ(path.at("side").at("vote"), "given normals");
  EXPECT_EQ(judged.out.find("turned normals"), std::string::npos) << judged.out;
  EXPECT_LT(path.at("material").at("gouge").at("value").get<double>(), 0.05);
}

TEST_F(Side, DrivePathsUseTheSameRule)
{
  write("front.pcd", pcd(jug(0.25), "250 250 -60 1 0 0 0"));
  const auto drive = [&](Arguments arguments) {
    arguments.insert(arguments.begin(), {"front.pcd", "--tool-radius", "3", "--step-over", "4", "--axis-mode", "surface", "-o", "d.json"});
    const RunResult run = endOf(startProgram(PCL_SPIRAL_DRIVE_PROGRAM, arguments, folder_), folder_);
    EXPECT_EQ(run.code, 0) << run.err;
    return run;
  };
  EXPECT_NE(drive({}).out.find("side            by the view point"), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(readText(folder_.path("d.json"))).at("side").at("vote"), "view point");
  const RunResult within = drive({"--view-point", "0,0,80"});
  EXPECT_NE(within.out.find("the hollow side"), std::string::npos) << within.out;
}

} // namespace

TEST_F(Side, ACameraAtTheOriginIsHeeded)
{
  // A cap of a sphere about (0, 0, 400) that bulges towards the camera: it sees only what faces -z.
  std::ostringstream text;
  text << std::setprecision(9) << "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 60\nHEIGHT 60\n"
       << "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 3600\nDATA ascii\n";
  for (int row = 0; row < 60; ++row)
    for (int column = 0; column < 60; ++column) {
      const double u = 0.1 * (column - 29.5) / 29.5, v = 0.1 * (row - 29.5) / 29.5, square = 1.0 + u * u + v * v;
      const double z = (400.0 - std::sqrt(400.0 * 400.0 - square * (400.0 * 400.0 - 100.0 * 100.0))) / square;
      text << z * u << ' ' << z * v << ' ' << z << '\n';
    }
  write("camera.pcd", text.str());
  outside("camera.pcd");
  expectSide("by the view point");
  expectWarning("on the side that a camera there sees, which faces away from +z");
  EXPECT_LT(report_.at("surface").at("side").at("z_cosine"), -0.5);
  outside("camera.pcd", {"--view-point", "0,0,-100"});
  EXPECT_EQ(run_.err.find("camera"), std::string::npos) << run_.err;
  outside("camera.pcd", {"--flip-normals"});
  EXPECT_EQ(run_.err.find("camera"), std::string::npos) << run_.err;
}

} // namespace side_test
