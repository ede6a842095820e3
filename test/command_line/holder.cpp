// SPDX-License-Identifier: BSD-3-Clause
// A holder along the spiral and along programs: a wall beside the part, the depth by brute force from the path file, and every remedy.
#include "command_line/run_program.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace holder_test {

using Eigen::Vector3d;

namespace {

const std::string spiral = PCL_SPIRAL_TOOLPATH_PROGRAM, drive = PCL_SPIRAL_DRIVE_PROGRAM;
const std::string machines = PCL_SPIRAL_MACHINES_DIR;
using Words = std::vector<std::string>;

constexpr double disc_radius = 24.0, wall_x = 36.0, wall_top = 60.0;
const Words tool{"--flank-length", "20", "--holder", "16,20"}; // from 25 to 45 mm above the tip

void
expectHas(const std::string& text, const std::string& part)
{
  EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' in: " << text;
}

std::string
textOf(const std::vector<Vector3d>& points)
{
  std::ostringstream text;
  text.precision(9);
  for (const Vector3d& p : points)
    text << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  return text.str();
}

/** A flat disc about the origin. */
std::vector<Vector3d>
disc()
{
  std::vector<Vector3d> points;
  std::mt19937 random(4);
  std::uniform_real_distribution<double> unit(-0.2, 0.2);
  for (int i = -30; i <= 30; ++i)
    for (int k = -30; k <= 30; ++k)
      if (std::hypot(i, k) <= disc_radius)
        points.push_back({i + unit(random), k + unit(random), 0.0});
  return points;
}

/** A wall beside it, 20 mm wide. */
std::vector<Vector3d>
wall()
{
  std::vector<Vector3d> points;
  for (int i = -10; i <= 10; ++i)
    for (int k = 0; k <= static_cast<int>(wall_top); ++k)
      points.push_back({wall_x, static_cast<double>(i), static_cast<double>(k)});
  return points;
}

std::vector<Vector3d>
joined(std::vector<Vector3d> points, const std::vector<Vector3d>& more)
{
  points.insert(points.end(), more.begin(), more.end());
  return points;
}

/** The columns of a .csv by their names, one vector per line. */
std::vector<std::vector<double>>
columns(const std::string& csv, const Words& names)
{
  std::istringstream text(csv);
  std::string line, word;
  std::getline(text, line);
  Words head;
  for (std::istringstream words(line); std::getline(words, word, ',');)
    head.push_back(word);
  std::vector<std::vector<double>> rows;
  while (std::getline(text, line)) {
    std::vector<double> all, row;
    for (std::istringstream words(line); std::getline(words, word, ',');)
      all.push_back(std::stod(word));
    for (const std::string& name : names) {
      const auto at = std::find(head.begin(), head.end(), name);
      EXPECT_NE(at, head.end()) << name;
      row.push_back(all[static_cast<std::size_t>(at - head.begin())]);
    }
    rows.push_back(row);
  }
  return rows;
}

/** How deep a point is in a cylinder about the axis, from \p low to \p high above the tip, at any line of the path: through its side. */
double
deepest(const std::string& csv, const std::vector<Vector3d>& points, double radius, double low, double high)
{
  double most = 0.0;
  for (const std::vector<double>& row : columns(csv, {"tip_x", "tip_y", "tip_z", "axis_x", "axis_y", "axis_z"})) {
    const Vector3d tip(row[0], row[1], row[2]), axis(row[3], row[4], row[5]);
    for (const Vector3d& p : points) {
      const double up = axis.dot(p - tip);
      if (up > low && up < high)
        most = std::max(most, radius - (p - tip - up * axis).norm());
    }
  }
  return most;
}

/** The number after "would be ". */
double
depthSaid(const std::string& text)
{
  const std::size_t at = text.find(" would be ");
  return at == std::string::npos ? -1.0 : std::stod(text.substr(at + 10));
}

class SpiralHolder : public testing::Test {
protected:
  RunResult run(const Words& more, const std::string& tilt = "0")
  {
    Words call{"part.xyz", "--tool-radius", "5", "--scallop", "0.8", "--part-at", "0,0,0", "-o", "a.csv", "--tilt", tilt};
    call.insert(call.end(), more.begin(), more.end());
    std::filesystem::remove(folder.path("a.csv"));
    return endOf(startProgram(spiral, call, folder), folder);
  }
  bool isWritten() const { return std::filesystem::exists(folder.path("a.csv")); }

  const ScratchFolder folder;
};

} // namespace

TEST_F(SpiralHolder, AWallBesideThePartIsMetByTheHolderAndEveryRemedyHelps)
{
  writeText(folder.path("part.xyz"), textOf(joined(disc(), wall())));
  const RunResult plain = run({});
  ASSERT_EQ(plain.code, 0) << plain.err;
  const double expected = deepest(readText(folder.path("a.csv")), wall(), 16.0, 25.0, 45.0);
  ASSERT_GT(expected, 3.0);
  ASSERT_LT(deepest(readText(folder.path("a.csv")), wall(), 5.0, 5.0, 25.0), 1e-9) << "the shank passes";

  const RunResult refused = run(tool);
  EXPECT_EQ(refused.code, 1);
  EXPECT_FALSE(isWritten());
  EXPECT_NEAR(depthSaid(refused.err), expected, 0.01) << refused.err;
  for (const char* part : {"segment 1 of the holder would be ", " mm deep in the part on the path, at (36, ", "the tip at (", " of the ",
                           " cutting moves collide", "--tilt", "--lead", "--flank-length", "--holder", "--accept-collisions"})
    expectHas(refused.err, part);

  Words accept = tool;
  accept.push_back("--accept-collisions");
  const RunResult accepted = run(accept);
  EXPECT_EQ(accepted.code, 0) << accepted.err;
  EXPECT_TRUE(isWritten());
  expectHas(accepted.err, "warning: segment 1 of the holder would be ");

  for (const Words& remedy : {Words{"--flank-length", "60", "--holder", "16,20"}, Words{"--flank-length", "20", "--holder", "11,20"}}) {
    const RunResult done = run(remedy);
    EXPECT_EQ(done.code, 0) << done.err;
    EXPECT_EQ(done.err.find("would be"), std::string::npos) << done.err;
  }
  const RunResult leaning = run(tool, "-20");
  EXPECT_EQ(leaning.code, 0) << leaning.err;
  EXPECT_LT(deepest(readText(folder.path("a.csv")), wall(), 16.0, 25.0, 45.0), 1e-9) << "inwards";
}

TEST_F(SpiralHolder, TheClearanceIsKept)
{
  writeText(folder.path("part.xyz"), textOf(joined(disc(), wall())));
  const RunResult plain = run({});
  ASSERT_EQ(plain.code, 0) << plain.err;
  const double reach = 16.0 - deepest(readText(folder.path("a.csv")), wall(), 16.0, 25.0, 45.0); // of the axis to the wall
  const auto radius = [&](double off) { return std::to_string(reach + off) + ",20"; };
  EXPECT_EQ(run({"--flank-length", "20", "--holder", radius(-0.1)}).code, 0);
  const RunResult near = run({"--flank-length", "20", "--holder", radius(-0.1), "--holder-clearance", "0.2"});
  EXPECT_EQ(near.code, 1);
  EXPECT_NEAR(depthSaid(near.err), 0.1, 0.01) << near.err;
}

/** The wall is one part of the mesh, two triangles with no vertex near the path; the path runs over the other. */
TEST_F(SpiralHolder, TheWholeMeshIsLookedAtNotOnlyThePart)
{
  std::ostringstream text;
  constexpr int n = 24;
  for (int i = 0; i <= n; ++i)
    for (int k = 0; k <= n; ++k)
      text << "v " << 2.0 * i - n << ' ' << 2.0 * k - n << " 0\n";
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) {
      const int a = i * (n + 1) + k + 1, b = a + n + 1;
      text << "f " << a << ' ' << b << ' ' << b + 1 << "\nf " << a << ' ' << b + 1 << ' ' << a + 1 << '\n';
    }
  const int first = (n + 1) * (n + 1) + 1;
  for (const auto& [y, z] : {std::pair(-12, 20), std::pair(12, 20), std::pair(12, 60), std::pair(-12, 60)})
    text << "v " << wall_x << ' ' << y << ' ' << z << '\n';
  text << "f " << first << ' ' << first + 1 << ' ' << first + 2 << "\nf " << first << ' ' << first + 2 << ' ' << first + 3 << '\n';
  writeText(folder.path("part.obj"), text.str());
  const auto made = [&](const Words& more) {
    Words call{"part.obj", "--mesh", "--largest", "--tool-radius", "5", "--scallop", "0.8", "--tilt", "0", "-o", "a.csv"};
    call.insert(call.end(), more.begin(), more.end());
    std::filesystem::remove(folder.path("a.csv"));
    return endOf(startProgram(spiral, call, folder), folder);
  };
  ASSERT_EQ(made({}).code, 0);
  double nearest = 1e9;
  for (const std::vector<double>& row : columns(readText(folder.path("a.csv")), {"tip_x", "tip_y"}))
    if (std::abs(row[1]) < 12.0)
      nearest = std::min(nearest, wall_x - row[0]);
  const RunResult refused = made(tool);
  EXPECT_EQ(refused.code, 1);
  EXPECT_NEAR(depthSaid(refused.err), 16.0 - nearest, 0.02) << refused.err;
  EXPECT_EQ(made({"--flank-length", "20", "--holder", std::to_string(nearest - 0.1) + ",20"}).code, 0);
}

TEST_F(SpiralHolder, WrongCallsAreRefused)
{
  writeText(folder.path("part.xyz"), textOf(disc()));
  const auto said = [&](const Words& more) {
    const RunResult done = run(more);
    EXPECT_EQ(done.code, 2) << done.err;
    return done.err;
  };
  expectHas(said({"--holder", "20,40"}), "--holder: no --flank-length is given");
  expectHas(said({"--flank-length", "20"}), "--flank-length: no --holder is given");
  expectHas(said({"--holder-clearance", "1"}), "--holder-clearance: no --holder is given");
  expectHas(said({"--flank-length", "20", "--holder", "20"}), "--holder 20: give segments");
  expectHas(said({"--flank-length", "20", "--holder", "20,-4"}), "set its length above 0");
  expectHas(said({"--accept-collisions"}), "--accept-collisions: no --holder is given");
}

/** One pass beside the pole of a slow table: the machine leans the axis farther to the wall than the path does. */
TEST(ProgramHolder, AnAxisBlendedAtThePoleMayNotBringTheHolderIntoAWall)
{
  const ScratchFolder folder;
  std::vector<Vector3d> points;
  std::mt19937 random(4);
  std::uniform_real_distribution<double> unit(-0.2, 0.2);
  for (int i = -40; i <= 40; ++i)
    for (int k = -40; k <= 40; ++k) {
      const double x = i + unit(random), y = k + unit(random);
      if (std::hypot(x, y) <= 40.0)
        points.push_back({x, y, std::sqrt(1e4 - x * x - y * y) - 100.0});
    }
  for (int i = -40; i <= 40; ++i)
    for (int k = 60; k <= 120; ++k)
      points.push_back({1.0 * i, 44.2, 1.0 * k});
  writeText(folder.path("part.xyz"), textOf(points));
  std::ostringstream curve;
  for (int i = -100; i <= 100; ++i)
    curve << 0.2 * i << " 1 " << std::sqrt(1e4 - 0.04 * i * i - 1.0) - 100.0 << '\n';
  writeText(folder.path("curve.xyz"), curve.str());
  std::string machine = readText(machines + "/xyzac.yaml");
  machine.replace(machine.find("max_rpm: 30"), 11, "max_rpm: 5 ");
  writeText(folder.path("slow.yaml"), machine);
  const auto made = [&](const Words& more) {
    Words call{"part.xyz",    "--crop",    "-41,41,-41,41", "--drive", "curve",          "--curve", "curve.xyz",
               "--axis-mode", "surface",   "--tool-radius", "5",       "--flank-length", "60",      "--holder",
               "41,60",       "--machine", "slow.yaml",     "-o",      "a.csv"};
    call.insert(call.end(), more.begin(), more.end());
    return endOf(startProgram(drive, call, folder), folder);
  };
  const RunResult refused = made({"-o", "a.ngc"});
  EXPECT_EQ(refused.code, 1) << refused.out;
  EXPECT_FALSE(std::filesystem::exists(folder.path("a.ngc")));
  for (const char* part : {"segment 1 of the holder would be ", "on the path, at (", "44.2", "the tool axis is blended there by up to ",
                           "--pole-cone 0", "--accept-collisions"})
    expectHas(refused.err, part);
  const RunResult kept = made({"-o", "a.ngc", "--pole-cone", "0"});
  EXPECT_EQ(kept.code, 0) << kept.err;
  expectHas(kept.err, "blocks run below the feed");
  EXPECT_EQ(kept.err.find("would be"), std::string::npos) << kept.err;
  const RunResult accepted = made({"-o", "a.ngc", "--accept-collisions"});
  EXPECT_EQ(accepted.code, 0) << accepted.err;
  expectHas(accepted.err, "warning: segment 1 of the holder would be ");
}

} // namespace holder_test
