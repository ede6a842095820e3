// SPDX-License-Identifier: BSD-3-Clause
// The part is chosen by a place, a crop and keep-outs, in the coordinates of the file: a cap over a table, with a clamp on it. The path
// is judged against the exact cap and the exact polygon.
#include <pcl_spiral/io/toolpath_reader.h>

#include "run_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <random>
#include <regex>
#include <sstream>

namespace part_test {

namespace {

using Arguments = std::vector<std::string>;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double ball = 100.0, rim = 40.0, radius = 4.0, scallop = 0.05, table = -70.0, clamp_top = 12.0; // mm
const std::vector<Vector2d> clamp{{14.0, -6.0}, {29.0, -3.0}, {27.0, 7.0}, {12.0, 4.0}};

/** Coordinates of the file: (mm) / unit + origin. */
struct Frame {
  double unit = 1.0;
  Vector3d origin = Vector3d::Zero();
  Vector3d inFile(const Vector3d& p) const { return p / unit + origin; }
};

std::string
text(const Vector3d& p, const char* separator = " ")
{
  std::ostringstream out;
  out << std::setprecision(15) << p.x() << separator << p.y() << separator << p.z();
  return out.str();
}

bool
inClamp(const Vector2d& p)
{
  for (std::size_t i = 0; i < clamp.size(); ++i) {
    const Vector2d side = clamp[(i + 1) % clamp.size()] - clamp[i], to = p - clamp[i];
    if (side.x() * to.y() - side.y() * to.x() < 0.0)
      return false;
  }
  return true;
}

double
clampDistance(const Vector2d& p)
{
  if (inClamp(p))
    return 0.0;
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < clamp.size(); ++i) {
    const Vector2d side = clamp[(i + 1) % clamp.size()] - clamp[i];
    const double share = std::clamp((p - clamp[i]).dot(side) / side.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (clamp[i] + share * side - p).norm());
  }
  return least;
}

/** Distance of the shank, ten radii long over \p centre along \p axis, from the clamp, whose top is flat; negative: in it. */
double
shankClearance(const Vector3d& centre, const Vector3d& axis)
{
  double least = std::numeric_limits<double>::max();
  for (double s = 0.0; s <= 10.0 * radius; s += 0.25) {
    const Vector3d place = centre + s * axis;
    least = std::min(least, std::hypot(clampDistance(place.head<2>()), std::max(place.z() - clamp_top, 0.0)) - radius);
  }
  return least;
}

/** The same for all axes that lean from \p normal by \p lean degrees. */
double
leaningClearance(const Vector3d& centre, const Vector3d& normal, double lean)
{
  const Vector3d across = normal.unitOrthogonal(), other = normal.cross(across);
  double least = shankClearance(centre, normal);
  for (int k = 0; k < 24; ++k) {
    const double angle = M_PI * k / 12.0, by = lean * M_PI / 180.0;
    const Vector3d axis = std::cos(by) * normal + std::sin(by) * (std::cos(angle) * across + std::sin(angle) * other);
    least = std::min(least, shankClearance(centre, axis));
  }
  return least;
}

Vector3d
onCap(double x, double y)
{
  return {x, y, std::sqrt(ball * ball - x * x - y * y) - ball};
}

/** Cap, clamp and table, seen from above. */
std::vector<Vector3d>
scene(bool with_clamp, bool with_table)
{
  std::mt19937 random(8);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::normal_distribution<double> noise(0.0, 0.003);
  std::vector<Vector3d> points;
  for (int i = 0; i < 9000; ++i) {
    const double r = rim * std::sqrt(unit(random)), angle = 2.0 * M_PI * unit(random);
    const Vector2d p(r * std::cos(angle), r * std::sin(angle));
    const bool up = with_clamp && inClamp(p);
    points.push_back(up ? Vector3d(p.x(), p.y(), clamp_top) : onCap(p.x(), p.y()) + Vector3d(0.0, 0.0, noise(random)));
  }
  for (int i = 0; with_table && i < 20000; ++i) {
    const Vector3d p(240.0 * unit(random) - 120.0, 240.0 * unit(random) - 120.0, table + noise(random));
    if (p.head<2>().norm() > rim)
      points.push_back(p);
  }
  return points;
}

class Part : public ::testing::Test {
protected:
  void write(const std::vector<Vector3d>& points, const Frame& frame = {})
  {
    std::ostringstream all, polygon;
    for (const Vector3d& p : points)
      all << text(frame.inFile(p)) << '\n';
    writeText(folder_.path("scan.xyz"), all.str());
    polygon << "# the clamp\n" << std::setprecision(15);
    for (const Vector2d& p : clamp)
      polygon << frame.inFile({p.x(), p.y(), 0.0}).head<2>().transpose() << '\n';
    writeText(folder_.path("keep.txt"), polygon.str());
  }

  RunResult run(Arguments arguments, const std::string& path = "a.csv")
  {
    const Arguments own{"scan.xyz", "-o", path, "-o", "a.json", "--tool-radius", "4", "--scallop", "0.05"};
    arguments.insert(arguments.begin(), own.begin(), own.end());
    return endOf(startProgram(PCL_SPIRAL_TOOLPATH_PROGRAM, arguments, folder_), folder_);
  }

  RunResult verify(Arguments arguments)
  {
    const Arguments own{"scan.xyz", "a.csv", "--tool-radius", "4", "--scallop", "0.05"};
    arguments.insert(arguments.begin(), own.begin(), own.end());
    return endOf(startProgram(PCL_SPIRAL_VERIFY_PROGRAM, arguments, folder_), folder_);
  }

  std::vector<Vector3d> centres() const
  {
    std::vector<Vector3d> all;
    for (const auto& p : pcl_spiral::readToolpath(folder_.path("a.csv")).path)
      all.push_back(p.getVector3fMap().cast<double>() + radius * p.getNormalVector3fMap().cast<double>());
    return all;
  }

  /** The path lies on the cap, and cuts it but for a band at the rim, and where ball or shank could come near the clamp. */
  void expectCapCut(bool keeps_out, double lean = 17.0)
  {
    const std::vector<Vector3d> way = centres();
    ASSERT_GT(way.size(), 500U);
    std::vector<Vector3d> close; // places of the centre
    for (std::size_t i = 0; i < way.size(); ++i) {
      EXPECT_NEAR((way[i] + Vector3d(0.0, 0.0, ball)).norm(), ball + radius, 0.05) << way[i].transpose();
      const Vector3d& next = way[std::min(i + 1, way.size() - 1)];
      for (int k = 0; k < 20; ++k) {
        close.push_back(way[i] + (next - way[i]) * (k / 20.0));
        if (keeps_out && (close.back() - Vector3d(20.5, 0.5, 0.0)).head<2>().norm() < 20.0) {
          ASSERT_GE(clampDistance(close.back().head<2>()), radius - 1e-4) << close.back().transpose();
        }
      }
    }
    constexpr double band = 3.0;
    int counted = 0;
    for (double x = -rim; x <= rim; x += 2.3)
      for (double y = -rim; y <= rim; y += 2.3) {
        if (std::hypot(x, y) > rim - 1.5 * band)
          continue;
        const Vector3d p = onCap(x, y);
        const Vector3d centre = p + radius * (p + Vector3d(0.0, 0.0, ball)) / ball;
        if (keeps_out && leaningClearance(centre, (p + Vector3d(0.0, 0.0, ball)) / ball, lean) < band)
          continue;
        ++counted;
        double least = std::numeric_limits<double>::max();
        for (const Vector3d& c : close)
          least = std::min(least, (c - p).squaredNorm());
        EXPECT_LT(std::sqrt(least) - radius, 2.0 * scallop) << "not cut: " << p.transpose();
      }
    EXPECT_GT(counted, 400);
  }

  /** The shank is not in the clamp anywhere. */
  void expectShankClear() const
  {
    for (const auto& p : pcl_spiral::readToolpath(folder_.path("a.csv")).path) {
      const Vector3d axis = p.getAxisVector3fMap().cast<double>();
      const Vector3d centre = p.getVector3fMap().cast<double>() + radius * p.getNormalVector3fMap().cast<double>();
      ASSERT_GT(shankClearance(centre, axis), -0.02) << centre.transpose();
    }
  }

  /** The numbers of "... at (1, 2, 3)" behind \p words. */
  static std::string placeAfter(const std::string& message, const std::string& words)
  {
    std::smatch found;
    const std::regex place(words + R"(\((-?[0-9.e+]+), (-?[0-9.e+]+), (-?[0-9.e+]+)\))");
    if (!std::regex_search(message, found, place))
      return "";
    return found[1].str() + "," + found[2].str() + "," + found[3].str();
  }

  ScratchFolder folder_;
};

} // namespace

TEST_F(Part, TheRefusalOfTwoPartsNamesPlacesThatChooseThem)
{
  write(scene(false, true));
  const RunResult refused = run({});
  EXPECT_EQ(refused.code, 1);
  EXPECT_NE(refused.err.find("2 separate parts"), std::string::npos) << refused.err;
  EXPECT_NE(refused.err.find("(--part-at)"), std::string::npos) << refused.err;
  const std::string second = placeAfter(refused.err, "mm2 at \\([^)]*\\), [0-9.e+]+ mm2 at ");
  ASSERT_FALSE(second.empty()) << refused.err;
  const RunResult chosen = run({"--part-at", second});
  ASSERT_EQ(chosen.code, 0) << chosen.err;
  EXPECT_NE(chosen.err.find("kept only the part nearest to"), std::string::npos) << chosen.err;
  EXPECT_NE(chosen.err.find("% of the points"), std::string::npos) << chosen.err;
  expectCapCut(false);
}

TEST_F(Part, TheLargestPartIsNamedWithItsShareAndTheRemedy)
{
  write(scene(false, true));
  const RunResult largest = run({"--largest", "--tight", "ride"});
  const RunResult plain = largest.code == 2 ? run({"--largest"}) : largest; // versions without --tight
  EXPECT_NE(plain.err.find("kept only the largest of 2 separate parts"), std::string::npos) << plain.err;
  EXPECT_NE(plain.err.find("% of the points"), std::string::npos) << plain.err;
  EXPECT_NE(plain.err.find("by 240 by"), std::string::npos) << "its size: " << plain.err;
  EXPECT_NE(plain.err.find("(--part-at)"), std::string::npos) << plain.err;
}

TEST_F(Part, APlaceFarFromTheScanIsRefusedWithTheDistance)
{
  write(scene(false, true));
  const RunResult far = run({"--part-at", "0,0,50"});
  EXPECT_EQ(far.code, 2);
  EXPECT_NE(far.err.find("(0, 0, 50) is 50"), std::string::npos) << far.err;
  EXPECT_NE(far.err.find("mm2 at ("), std::string::npos) << far.err;
  EXPECT_FALSE(std::filesystem::exists(folder_.path("a.csv")));
}

TEST_F(Part, TheBallKeepsOutOfTheClampAndCutsAllElse)
{
  write(scene(true, true));
  const Arguments chosen{"--part-at", "-20,0,-2", "--keep-out", "keep.txt"};
  const RunResult result = run(chosen);
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.err.find("in a keep-out"), std::string::npos) << result.err;
  expectCapCut(true);
  expectShankClear();
  const RunResult judged = verify(chosen);
  EXPECT_EQ(judged.code, 0) << judged.err << judged.out;
  const std::string path = readText(folder_.path("a.csv"));
  writeText(folder_.path("report.json"), readText(folder_.path("a.json")));
  ASSERT_EQ(endOf(startProgram(PCL_SPIRAL_TOOLPATH_PROGRAM, {"--config", "report.json"}, folder_), folder_).code, 0) << "replayed";
  EXPECT_EQ(readText(folder_.path("a.csv")), path);
}

TEST_F(Part, AStraightToolGoesNearerToTheClamp)
{
  write(scene(true, false));
  ASSERT_EQ(run({"--keep-out", "keep.txt"}).code, 0);
  const auto nearest = [&] {
    double least = std::numeric_limits<double>::max();
    for (const Vector3d& c : centres())
      least = std::min(least, clampDistance(c.head<2>()));
    return least;
  };
  const double leaning = nearest();
  const RunResult straight = run({"--keep-out", "keep.txt", "--tilt", "0"});
  ASSERT_EQ(straight.code, 0) << straight.err;
  expectShankClear();
  expectCapCut(true, 2.0);
  EXPECT_LT(nearest(), leaning - 0.2);
}

TEST_F(Part, AProgramIsJudgedByThePointsThatItsToolCanReach)
{
  write(scene(true, false));
  for (const char* tilt : {"0", "15"}) {
    const RunResult made = run({"--keep-out", "keep.txt", "--tilt", tilt, "-o", "a.ngc"});
    ASSERT_EQ(made.code, 0) << made.err;
    const RunResult judged =
        endOf(startProgram(PCL_SPIRAL_VERIFY_PROGRAM,
                           {"scan.xyz", "a.ngc", "--machine", PCL_SPIRAL_MACHINES_DIR "/xyzac.yaml", "--tool-radius", "4", "--scallop",
                            "0.05", "--keep-out", "keep.txt", "--max-gouge", "0.03", "--max-uncut", "0"},
                           folder_),
              folder_);
    EXPECT_EQ(judged.code, 0) << tilt << ": " << judged.err << judged.out;
  }
}

TEST_F(Part, VerifyFindsAShankInTheClamp)
{
  write(scene(false, false)); // without the clamp the path goes on beside it
  writeText(folder_.path("beside.txt"), "14 -6\n29 -3\n27 7\n12 4\n");
  ASSERT_EQ(run({"--keep-out", "beside.txt"}).code, 0);
  EXPECT_EQ(verify({"--keep-out", "beside.txt"}).code, 0);
  write(scene(true, false));
  const RunResult judged = verify({"--keep-out", "beside.txt"});
  EXPECT_EQ(judged.code, 1);
  EXPECT_NE((judged.err + judged.out).find("where something stands in a keep-out"), std::string::npos) << judged.err << judged.out;
}

TEST_F(Part, CoordinatesAreThoseOfTheFile)
{
  write(scene(true, true));
  ASSERT_EQ(run({"--part-at", "-20,0,-2", "--keep-out", "keep.txt"}).code, 0);
  const std::size_t rows = centres().size();
  Frame map;
  map.unit = 1000.0;
  map.origin = {4000.0, 7000.0, 300.0};
  write(scene(true, true), map);
  const Arguments read{"--units", "m", "--origin", "4000,7000,300"};
  const auto with = [&](Arguments more) {
    more.insert(more.begin(), read.begin(), read.end());
    return more;
  };
  const std::string on_cap = text(map.inFile({-20.0, 0.0, -2.0}), ",");
  const RunResult result = run(with({"--part-at", on_cap, "--keep-out", "keep.txt"}));
  ASSERT_EQ(result.code, 0) << result.err;
  expectCapCut(true);
  EXPECT_NEAR(static_cast<double>(centres().size()), static_cast<double>(rows), 0.05 * static_cast<double>(rows));
  const std::string box = std::to_string(4000.0 - 0.045) + "," + std::to_string(4000.045) + "," + std::to_string(7000.0 - 0.045) + "," +
                          std::to_string(7000.045) + ",299.98,300.1";
  const RunResult cropped = run(with({"--crop", box, "--keep-out", "keep.txt"}));
  ASSERT_EQ(cropped.code, 0) << cropped.err;
  EXPECT_NE(cropped.err.find("outside the crop"), std::string::npos) << cropped.err;
  expectCapCut(true);
  write(scene(false, true), map);
  const RunResult refused = run(read);
  const std::string place = placeAfter(refused.err, "mm2 at ");
  std::smatch file_place;
  const std::regex in_file(R"(\(in the file ([-0-9.,e+]+)\))");
  ASSERT_TRUE(std::regex_search(refused.err, file_place, in_file)) << refused.err;
  EXPECT_NE(run(with({"--part-at", file_place[1].str()})).err.find("kept only the part nearest to"), std::string::npos);
}

TEST_F(Part, EveryPlaceInAMessageIsAlsoThatOfAFileInInches)
{
  constexpr double inch = 25.4;
  const auto expectPlaces = [](const RunResult& result, int code) {
    std::string said = result.err;
    std::istringstream table(result.out); // of figures, mm; messages in it are broken limits
    for (std::string line; std::getline(table, line);)
      said += line.find("LIMIT") == 0 ? line + '\n' : "";
    const std::string number = "([-0-9.e+]+)";
    EXPECT_EQ(result.code, code) << said;
    const std::regex place("\\(" + number + ", " + number + ", " + number + "\\)( \\(in the file " + number + "," + number + "," + number +
                           "\\))?");
    std::size_t places = 0;
    for (std::sregex_iterator i(said.begin(), said.end(), place), end; i != end; ++i, ++places) {
      ASSERT_TRUE((*i)[4].matched) << (*i)[0] << " in:\n" << said;
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(std::stod((*i)[1 + c]), inch * std::stod((*i)[5 + c]), 1e-6) << said;
    }
    EXPECT_GT(places, 0U) << said;
  };
  write(scene(true, true), {inch});
  const Arguments units{"--units", "inch"}, at{"--units", "inch", "--part-at", text(Vector3d(-20.0, 0.0, -2.0) / inch, ",")};
  expectPlaces(run(units), 1); // the separate parts
  expectPlaces(run(at), 1);    // the clamp in the way
  write(scene(false, false), {inch});
  expectPlaces(run({"--units", "inch", "--crop", "500,600,0,10"}), 2);
  ASSERT_EQ(run(units).code, 0);
  expectPlaces(verify({"--units", "inch", "--keep-out", "keep.txt"}), 1);
  expectPlaces(verify({"--units", "inch", "--max-deviation", "0"}), 1);
  write(scene(true, false), {inch});
  writeText(folder_.path("keep.txt"), "0.70 -0.04\n0.90 -0.04\n0.90 0.08\n0.70 0.08\n");
  expectPlaces(run({"--units", "inch", "--keep-out", "keep.txt"}), 1); // too small for the clamp
}

TEST_F(Part, VerifyFindsAPathThroughAKeepOut)
{
  write(scene(false, false));
  ASSERT_EQ(run({}).code, 0);
  EXPECT_EQ(verify({}).code, 0);
  const RunResult judged = verify({"--keep-out", "keep.txt"});
  EXPECT_EQ(judged.code, 1);
  EXPECT_NE((judged.err + judged.out).find("the ball enters a keep-out by 4"), std::string::npos) << judged.err << judged.out;
}

TEST_F(Part, AKeepOutThatIsTooSmallIsRefusedWithThePlace)
{
  write(scene(true, false));
  writeText(folder_.path("keep.txt"), "18 -1\n23 -1\n23 2\n18 2\n");
  const RunResult result = run({"--keep-out", "keep.txt"});
  EXPECT_NE(result.code, 0) << "the clamp stands beside: " << result.err;
  EXPECT_NE(result.err.find("at ("), std::string::npos) << result.err;
}

TEST_F(Part, CropsThatLeaveNothingAndWrongValues)
{
  write(scene(false, false));
  const auto refused = [&](const Arguments& arguments, int code, const std::string& words) {
    const RunResult result = run(arguments);
    EXPECT_EQ(result.code, code) << result.err;
    EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
  };
  refused({"--crop", "500,600,0,10"}, 2, "no point is left after --crop; the scan lies from (-");
  refused({"--crop", "0,10,20"}, 2, "xmin,xmax,ymin,ymax");
  refused({"--crop", "10,0,0,10"}, 2, "the second number");
  refused({"--crop", "nothing.txt"}, 1, "nothing.txt");
  refused({"--keep-out", "nothing.txt"}, 1, "nothing.txt");
  writeText(folder_.path("line.txt"), "0 0\n1 1\n2 2\n");
  refused({"--keep-out", "line.txt"}, 1, "no area");
}

TEST_F(Part, ADriveKeepsOutOfTheClampToo)
{
  write(scene(true, false));
  const RunResult result = endOf(
      startProgram(PCL_SPIRAL_DRIVE_PROGRAM,
                   {"scan.xyz", "-o", "d.csv", "--tool-radius", "4", "--corner-radius", "1", "--step-over", "2", "--keep-out", "keep.txt"},
                   folder_),
      folder_);
  ASSERT_EQ(result.code, 0) << result.err;
  const auto path = pcl_spiral::readToolpath(folder_.path("d.csv"));
  ASSERT_EQ(path.tips.size(), path.path.size());
  double nearest = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < path.tips.size(); ++i) {
    const bool same = i > 0 && path.path[i].turn == path.path[i - 1].turn;
    for (int k = 0; k <= 10; ++k) {
      const Vector3d tip = same ? Vector3d(path.tips[i - 1] + (path.tips[i] - path.tips[i - 1]) * (k / 10.0)) : Vector3d(path.tips[i]);
      nearest = std::min(nearest, clampDistance(tip.head<2>()));
    }
  }
  EXPECT_GE(nearest, radius - 1e-4);
  EXPECT_LE(nearest, radius + 1.1) << "as far as possible: within the point spacing";
}

} // namespace part_test
