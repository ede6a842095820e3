// SPDX-License-Identifier: BSD-3-Clause
// pcl_spiral_drive from outside: a column by a helix, planes over a cap, and messages for wrong command lines.
#include "command_line/cap_scan.h"
#include "command_line/run_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

namespace drive_test {

namespace {

const std::string program = PCL_SPIRAL_DRIVE_PROGRAM;
const std::string machines = PCL_SPIRAL_MACHINES_DIR;

/** A column of radius 20 about z with four lobes, 16 mm high, a point every mm. */
std::string
column()
{
  std::ostringstream text;
  for (int line = 0; line < 126; ++line)
    for (int i = 0; i < 17; ++i) {
      const double angle = 2.0 * M_PI * line / 126.0, z = i + 0.5 * (line % 2) - 0.25;
      const double r = 20.0 + std::sin(4.0 * angle);
      text << r * std::cos(angle) << ' ' << r * std::sin(angle) << ' ' << z << '\n';
    }
  return text.str();
}

RunResult
run(const ScratchFolder& folder, const std::vector<std::string>& arguments)
{
  writeText(folder.path("column.xyz"), column());
  writeText(folder.path("cap.xyz"), capScan(3000));
  return endOf(startProgram(program, arguments, folder), folder);
}

void
expectHas(const std::string& text, const std::string& part)
{
  EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' in: " << text;
}

/** The numbers of a row of the toolpath CSV. */
std::vector<std::vector<double>>
rows(const std::string& csv)
{
  std::vector<std::vector<double>> all;
  std::istringstream stream(csv);
  std::string line;
  std::getline(stream, line);
  while (std::getline(stream, line)) {
    std::istringstream words(line);
    std::vector<double> row;
    for (std::string word; std::getline(words, word, ',');)
      row.push_back(std::stod(word));
    all.push_back(row);
  }
  return all;
}

/** Rows of the toolpath CSV with which a pass after the first begins. */
std::vector<std::size_t>
passBegins(const std::string& csv)
{
  const auto all = rows(csv);
  std::vector<std::size_t> begins;
  for (std::size_t i = 1; i < all.size(); ++i)
    if (all[i][0] != all[i - 1][0])
      begins.push_back(i);
  return begins;
}

} // namespace

TEST(Drive, AReportMakesItsRunAgain)
{
  const ScratchFolder folder;
  const RunResult done = run(folder, {"cap.xyz", "--tool-radius", "3", "--corner-radius", "1", "--step-over", "2", "--direction", "30",
                                      "--one-way", "--axis", "0,0.1,1", "-o", "a.csv", "-o", "a.json"});
  ASSERT_EQ(done.code, 0) << done.err;
  const RunResult again = run(folder, {"--config", "a.json", "-o", "b.csv"});
  ASSERT_EQ(again.code, 0) << again.err;
  EXPECT_TRUE(readText(folder.path("a.csv")) == readText(folder.path("b.csv")));
}

TEST(Drive, AColumnByAHelixForAnyCutter)
{
  const ScratchFolder folder;
  const RunResult done = run(folder, {"column.xyz",
                                      "--drive",
                                      "helix",
                                      "--step-over",
                                      "2",
                                      "--tool-radius",
                                      "3",
                                      "--corner-radius",
                                      "0.5",
                                      "--flank-length",
                                      "10",
                                      "--point-spacing",
                                      "2",
                                      "--tolerance",
                                      "0.05",
                                      "-o",
                                      "a.csv",
                                      "-o",
                                      "a.vtp",
                                      "-o",
                                      "a.json",
                                      "-o",
                                      "a.ngc",
                                      "-o",
                                      "a.apt",
                                      "-o",
                                      "a.png",
                                      "--machine",
                                      machines + "/head_head.yaml"});
  ASSERT_EQ(done.code, 0) << done.err;
  expectHas(done.out, "drive path      helix: 1 pass, ");
  expectHas(done.out, "rotary axes     ");
  // The axis points out of the column, and the tip of the flat end is near its contact, inside the cutter.
  for (const std::vector<double>& row : rows(readText(folder.path("a.csv")))) {
    ASSERT_EQ(row.size(), 17U);
    const double tip = std::hypot(row[8], row[9]);
    ASSERT_NEAR(std::atan2(row[12], row[11]), std::atan2(row[9], row[8]), 0.02);
    ASSERT_GT(tip, 19.0 - 0.1);
    ASSERT_LT(tip, 21.6);
    ASSERT_LT(std::hypot(row[8] - row[2], row[9] - row[3], row[10] - row[4]), 4.0);
  }
  expectHas(readText(folder.path("a.json")), "\"unresolved_moves\": 0");
  expectHas(readText(folder.path("a.apt")), "CUTTER/6.000000,0.500000,2.500000,0.500000,0.000000,0.000000,");
  EXPECT_TRUE(std::filesystem::exists(folder.path("a.png")));
  EXPECT_TRUE(std::filesystem::exists(folder.path("a_rotary.png")));
}

/** Half of the column faces away from the axis; a helix cuts all of it. */
TEST(Drive, SurfaceThatPlanesDoNotReachIsAWarningWithItsRemedy)
{
  const ScratchFolder folder;
  const auto warned = [&folder](const std::vector<std::string>& path) {
    std::vector<std::string> arguments{"column.xyz", "--tool-radius", "3", "--step-over", "2", "--tolerance", "0.05", "-o", "a.csv"};
    arguments.insert(arguments.end(), path.begin(), path.end());
    const RunResult done = run(folder, arguments);
    EXPECT_EQ(done.code, 0) << done.err;
    return done.err;
  };
  const std::string planes = warned({"--axis", "1,0,0"});
  expectHas(planes, " % of the surface is not cut, such as at (");
  expectHas(planes, "choose another --axis, or for a column --drive helix");
  EXPECT_EQ(warned({"--drive", "helix"}).find("is not cut"), std::string::npos);
}

/** The wall leans at the lower end, so that the last ring touches it 0.4 mm beside its place: by the exact wall. */
TEST(Drive, AnEndThatRingsLeaveHigherThanTheScallopIsAWarningWithItsRemedy)
{
  const auto radius = [](double z) { return 20.0 + 0.7 * std::sin(z / 8.0); };
  const ScratchFolder folder;
  std::ostringstream scan;
  for (int line = 0; line < 160; ++line)
    for (int i = 0; i <= 40; ++i) {
      const double angle = 2.0 * M_PI * line / 160.0, z = 0.75 * i;
      scan << radius(z) * std::cos(angle) << ' ' << radius(z) * std::sin(angle) << ' ' << z << '\n';
    }
  writeText(folder.path("leaning.xyz"), scan.str());
  const auto drive = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"leaning.xyz", "--drive", "rings", "--tool-radius", "5", "--scallop", "0.05", "-o", "a.csv"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const RunResult done = run(folder, arguments);
    EXPECT_EQ(done.code, 0) << done.err;
    return done.err;
  };
  const auto leftAtEnd = [&] { // over the wall at z = 0, as the nearest ball
    double most = 0.0;
    const std::vector<std::vector<double>> path = rows(readText(folder.path("a.csv")));
    for (int k = 0; k < 36; ++k) {
      double least = 1e9;
      for (const std::vector<double>& row : path)
        least = std::min(least, std::hypot(row[2] + 5.0 * row[5] - radius(0.0) * std::cos(M_PI * k / 18.0),
                                           row[3] + 5.0 * row[6] - radius(0.0) * std::sin(M_PI * k / 18.0), row[4] + 5.0 * row[7]));
      most = std::max(most, least - 5.0);
    }
    return most;
  };
  const std::string warned = drive({}), remedy = "extend the path beyond the ends, such as --overrun ";
  expectHas(warned, " mm at an end of the column are not cut");
  expectHas(warned, remedy);
  EXPECT_GT(leftAtEnd(), 0.08);
  std::istringstream rest(warned.substr(warned.find(remedy) + remedy.size()));
  std::string overrun;
  rest >> overrun;
  EXPECT_EQ(drive({"--overrun", overrun}).find("are not cut"), std::string::npos);
  EXPECT_LT(leftAtEnd(), 0.055);
}

TEST(Drive, PlanesAreOnePassEachAndLeaveTheSurfaceBetween)
{
  const ScratchFolder folder;
  const RunResult done =
      run(folder, {"cap.xyz", "--tool-radius", "4", "--scallop", "0.2", "--tolerance", "0.05", "-o", "a.csv", "-o", "a.ngc"});
  ASSERT_EQ(done.code, 0) << done.err;
  const auto all = rows(readText(folder.path("a.csv")));
  std::size_t passes = 1;
  double least = 1e9, largest = -1e9;
  for (std::size_t i = 1; i < all.size(); ++i)
    passes += all[i][0] != all[i - 1][0];
  for (const auto& row : all) {
    least = std::min(least, row[9]);
    largest = std::max(largest, row[9]);
  }
  // at most 2 sqrt(R^2 - (R - h)^2) apart
  EXPECT_NEAR(static_cast<double>(passes), (largest - least) / (2.0 * std::sqrt(16.0 - 3.8 * 3.8)) + 1.0, 1.6);
  const std::string call = "export HOME='" + folder.root().string() + "'; cd '" + machines + "/rs274' && rs274 -i rs274.ini -g '" +
                           folder.path("a.ngc") + "' '" + folder.path("canon.txt") + "' 2>'" + folder.path("messages.txt") + "'";
  ASSERT_EQ(std::system(call.c_str()), 0) << readText(folder.path("messages.txt"));
  const RunResult others = run(
      folder, {"cap.xyz", "--tool-radius", "4", "--corner-radius", "1", "--step-over", "8", "-o", "b.apt", "-o", "b.yaml", "-o", "b.csv"});
  ASSERT_EQ(others.code, 0) << others.err;
  std::size_t apart = 1;
  const auto lines = rows(readText(folder.path("b.csv")));
  for (std::size_t i = 1; i < lines.size(); ++i)
    apart += lines[i][0] != lines[i - 1][0];
  EXPECT_GT(apart, 2U);
  const auto count = [](const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
      ++found;
    return found;
  };
  const std::size_t rapids = count(readText(folder.path("b.apt")), "RAPID\n"); // the highest rows climb to the top at once
  EXPECT_GE(rapids, 3 * apart);
  EXPECT_LE(rapids, 5 * apart);
  EXPECT_EQ(count(readText(folder.path("b.yaml")), "- - {x: "), apart);
}

TEST(Drive, RowsAreKeptToTheScallopAndJoined)
{
  const ScratchFolder folder;
  const std::vector<std::string> call{"cap.xyz", "--tool-radius", "4",  "--scallop", "0.2", "--tolerance", "0.05",
                                      "-o",      "a.csv",         "-o", "a.json"};
  const RunResult even = run(folder, call);
  ASSERT_EQ(even.code, 0) << even.err;
  expectHas(readText(folder.path("a.json")), "\"links\": 0");
  std::vector<std::string> kept = call;
  kept.insert(kept.end(), {"--rows", "kept", "--link"});
  const RunResult done = run(folder, kept);
  ASSERT_EQ(done.code, 0) << done.err;
  expectHas(done.out, " that keep the scallop height, ");
  expectHas(done.out, " rows joined on the surface, ");
  const std::string report = readText(folder.path("a.json"));
  expectHas(report, "\"rows\": \"kept\"");
  expectHas(report, "\"smallest_step\": ");
  std::size_t passes = 1;
  const auto all = rows(readText(folder.path("a.csv")));
  for (std::size_t i = 1; i < all.size(); ++i)
    passes += all[i][0] != all[i - 1][0];
  expectHas(report, "\"passes\": " + std::to_string(passes) + ",");
  expectHas(report, "\"apart\": " + std::to_string(passes - 1));
  expectHas(done.out, ": " + std::to_string(passes) + " pass");
}

TEST(Drive, APictureOfThePassesNeedsADisplayAndNoMachine)
{
  const ScratchFolder folder;
  const std::vector<std::string> call{"cap.xyz", "--tool-radius", "4", "--step-over", "4", "--tolerance", "0.1", "-o", "a.png"};
  if (std::getenv("DISPLAY")) {
    const RunResult done = run(folder, call);
    ASSERT_EQ(done.code, 0) << done.err;
    expectHas(done.out, "written         a.png\n");
    EXPECT_GT(std::filesystem::file_size(folder.path("a.png")), 20000U);
    EXPECT_FALSE(std::filesystem::exists(folder.path("a_rotary.png")));
  }
  std::vector<std::string> twice = call;
  twice.insert(twice.end(), {"-o", "a_rotary.png", "--machine", machines + "/xyzac.yaml"});
  const RunResult clash = run(folder, twice);
  EXPECT_EQ(clash.code, 2);
  expectHas(clash.err, "-o a_rotary.png: is given twice");
  const char* const before = std::getenv("DISPLAY");
  const std::string kept = before ? before : "";
  ::unsetenv("DISPLAY");
  const RunResult blind = run(folder, {"cap.xyz", "--tool-radius", "4", "--step-over", "4", "-o", "b.png", "-o", "b.csv"});
  if (before)
    ::setenv("DISPLAY", kept.c_str(), 1);
  EXPECT_EQ(blind.code, 1);
  expectHas(blind.err, "DISPLAY is not set");
  expectHas(blind.err, "xvfb-run -a");
  EXPECT_FALSE(std::filesystem::exists(folder.path("b.csv")));
}

TEST(Drive, AHolderThatWouldCollideIsRefused)
{
  const ScratchFolder folder;
  const std::vector<std::string> call{"cap.xyz",  "--tool-radius", "1",      "--flank-length", "2",  "--step-over", "8",
                                      "--holder", "0.9,1/30,20",   "--axis", "0.6,0,1",        "-o", "a.csv"};
  const RunResult refused = run(folder, call);
  EXPECT_EQ(refused.code, 1);
  expectHas(refused.err, "segment 2 of the holder would be ");
  expectHas(refused.err, "--accept-collisions");
  EXPECT_FALSE(std::filesystem::exists(folder.path("a.csv")));
  std::vector<std::string> accepted = call;
  accepted.push_back("--accept-collisions");
  const RunResult done = run(folder, accepted);
  EXPECT_EQ(done.code, 0) << done.err;
  expectHas(done.out, "collisions      shank or holder at ");
}

/** Its normals have four directions: they define no axis. */
TEST(Drive, ASquareColumnGoesRoundTheAxisGiven)
{
  const ScratchFolder folder;
  std::ostringstream text; // 20 mm wide with edges of radius 3, about (5, 7), 16 mm high
  for (int line = 0; line < 140; ++line)
    for (int i = 0; i < 33; ++i) {
      const double angle = 2.0 * M_PI * line / 140.0, c = std::cos(angle), s = std::sin(angle);
      double r = 7.0; // out to where the distance from the inner square is the edge's radius
      for (int step = 0; step < 60; ++step)
        r += 3.0 - std::hypot(std::max(0.0, r * std::abs(c) - 7.0), std::max(0.0, r * std::abs(s) - 7.0));
      text << 5.0 + r * c << ' ' << 7.0 + r * s << ' ' << 0.5 * i + 0.25 * (line % 2) << '\n';
    }
  writeText(folder.path("square.xyz"), text.str());
  const std::vector<std::string> call{"square.xyz", "--drive",     "helix", "--step-over", "2",    "--tool-radius",
                                      "3",          "--tolerance", "0.05",  "-o",          "a.csv"};
  const RunResult refused = endOf(startProgram(program, call, folder), folder);
  EXPECT_EQ(refused.code, 1);
  expectHas(refused.err, "--column-axis");
  std::vector<std::string> given = call;
  given.insert(given.end(), {"--column-axis", "0,0,2", "--column-centre", "5,7,0"});
  const RunResult done = endOf(startProgram(program, given, folder), folder);
  ASSERT_EQ(done.code, 0) << done.err;
  for (const std::vector<double>& row : rows(readText(folder.path("a.csv")))) {
    const double x = row[2] - 5.0, y = row[3] - 7.0, angle = std::atan2(row[12], row[11]);
    const double out = std::hypot(std::max(0.0, std::abs(x) - 7.0), std::max(0.0, std::abs(y) - 7.0));
    ASSERT_NEAR(out, 3.0, 0.05) << "contacts lie on the column";
    ASSERT_NEAR(std::cos(angle) * (row[9] - 7.0) - std::sin(angle) * (row[8] - 5.0), 0.0, 0.02) << "axes meet that given";
    ASSERT_NEAR(row[13], 0.0, 1e-6);
  }
}

TEST(Drive, OutliersAreClimbedOverOrLeftOut)
{
  const ScratchFolder folder;
  writeText(folder.path("outliers.xyz"), capScan(6000) + "3 4 9\n-12 5 7\n20 -9 6\n");
  const auto highest = [&](const std::vector<std::string>& more, RunResult& done) {
    std::vector<std::string> call{"outliers.xyz", "--tool-radius", "4", "--step-over", "2", "--tolerance", "0.1", "-o", "a.csv"};
    call.insert(call.end(), more.begin(), more.end());
    done = endOf(startProgram(program, call, folder), folder);
    double z = -1e9;
    for (const auto& row : rows(readText(folder.path("a.csv"))))
      z = std::max(z, row[10]);
    return z;
  };
  RunResult kept, left_out;
  EXPECT_GT(highest({}, kept), 8.5);
  expectHas(kept.err, "3 points of the scan are outliers");
  expectHas(kept.err, "--leave-out-strays");
  EXPECT_LT(highest({"--leave-out-strays"}, left_out), 0.1);
  expectHas(left_out.err,
            "3 of 6003 points off the scanned surface were left out (--leave-out-strays); the largest group has 1, at (3, 4, 9)");
}

TEST(Drive, MessagesNameOptionsThatThereAre)
{
  const ScratchFolder folder;
  std::istringstream cap(capScan(3000));
  std::ostringstream two, noisy;
  two << cap.str();
  for (double x, y, z; cap >> x >> y >> z;)
    two << 0.5 * x + 120.0 << ' ' << 0.5 * y << ' ' << z + 5.0 << '\n';
  writeText(folder.path("two.xyz"), two.str());
  writeText(folder.path("noisy.xyz"), capScan(8000, 0.6));
  const auto driven = [&](std::vector<std::string> call, const std::vector<std::string>& more) {
    call.insert(call.end(), {"--tool-radius", "3", "--step-over", "4", "--tolerance", "0.1", "-o", "a.csv"});
    call.insert(call.end(), more.begin(), more.end());
    return endOf(startProgram(program, call, folder), folder);
  };
  const RunResult parts = driven({"two.xyz", "--drive", "offset"}, {});
  EXPECT_EQ(parts.code, 1);
  expectHas(parts.err, "keep only the largest one (--largest)");
  const RunResult largest = driven({"two.xyz", "--drive", "offset"}, {"--largest"});
  EXPECT_EQ(largest.code, 0) << largest.err;
  for (const auto& row : rows(readText(folder.path("a.csv"))))
    ASSERT_LT(row[8], 60.0) << "nothing on the other part";
  const RunResult scattered = driven({"noisy.xyz"}, {});
  expectHas(scattered.err, "passes are ragged");
  expectHas(scattered.err, "cannot be told from folds of the part");
  const RunResult thinned = driven({"noisy.xyz"}, {"--thin", "2.4"});
  EXPECT_EQ(thinned.code, 0) << thinned.err;
  EXPECT_EQ(thinned.err.find("passes are ragged"), std::string::npos) << thinned.err;
  const RunResult wrong = driven({"noisy.xyz"}, {"--thin", "-1"});
  EXPECT_EQ(wrong.code, 2);
  expectHas(wrong.err, "--thin");
}

TEST(Drive, AxesAreBlendedAtThePoleForABallAlone)
{
  const ScratchFolder folder;
  const std::vector<std::string> call{"cap.xyz",       "--axis-mode", "surface", "--step-over", "9",
                                      "--tool-radius", "3",           "--feed",  "5000",        "--tolerance",
                                      "0.05",          "-o",          "a.ngc",   "--machine",   machines + "/xyzac.yaml"};
  const RunResult ball = run(folder, call);
  ASSERT_EQ(ball.code, 0) << ball.err;
  expectHas(ball.err, "the tool axis was blended");
  std::vector<std::string> other = call;
  other.insert(other.end(), {"--corner-radius", "1"});
  const RunResult bull_nose = run(folder, other);
  ASSERT_EQ(bull_nose.code, 0) << bull_nose.err;
  EXPECT_EQ(bull_nose.err.find("blended"), std::string::npos) << bull_nose.err;
  expectHas(bull_nose.err, "run below the feed");
}

/** A scan, a point every mm, of z = height(y) over a square of 40 mm. */
template <typename Height>
std::string
sheet(const Height& height)
{
  std::ostringstream text;
  for (int i = 0; i <= 40; ++i)
    for (int k = 0; k <= 40; ++k)
      text << i << ' ' << k << ' ' << height(static_cast<double>(k)) << '\n';
  return text.str();
}

/** Rows of a bull-nose along the contour of a slope of 30 degrees, against the circles of its rounded corner. */
TEST(Drive, TheScallopOfABullNoseHoldsOnASlope)
{
  const ScratchFolder folder;
  writeText(folder.path("slope.xyz"), sheet([](double y) { return 0.57735026919 * y; }));
  std::vector<std::string> call{"slope.xyz", "--tool-radius", "10", "--corner-radius", "2", "--scallop", "0.02", "--tolerance", "1e-3",
                                "-o",        "a.csv"};
  const RunResult done = run(folder, call);
  ASSERT_EQ(done.code, 0) << done.err;
  std::vector<double> tips; // y of each row
  double lowest = 1e9;
  for (const auto& row : rows(readText(folder.path("a.csv")))) {
    lowest = std::min(lowest, row[1]);
    tips.push_back(row[9]);
  }
  std::sort(tips.begin(), tips.end());
  double widest = 0.0;
  for (std::size_t i = 1; i < tips.size(); ++i)
    widest = std::max(widest, (tips[i] - tips[i - 1]) / std::cos(M_PI / 6.0)); // along the slope
  EXPECT_LE(2.0 - std::sqrt(4.0 - 0.25 * widest * widest), 0.021) << widest;
  EXPECT_LE(lowest, 0.3) << "of the contacts from the lower rim";
  call.back() = "even.csv";
  call.insert(call.end() - 2, {"--rows", "even"});
  const RunResult even = run(folder, call);
  EXPECT_EQ(even.code, 1);
  expectHas(even.err, "the passes leave more than the --scallop of 0.02 mm on ");
  expectHas(even.err, "use --rows kept");
  EXPECT_FALSE(std::filesystem::exists(folder.path("even.csv")));
}

/** A disc of 16 mm leaves up to 8^2 k / 2 in a hollow of curvature k: the figure named, and each remedy is true. */
TEST(Drive, AScallopThatACutterCannotKeepIsRefusedWithTheFigure)
{
  const ScratchFolder folder;
  writeText(folder.path("hollow.xyz"), sheet([](double y) { return (y - 20.0) * (y - 20.0) / 200.0; })); // radius 100
  const auto drive = [&](const std::vector<std::string>& more) {
    std::vector<std::string> call{"hollow.xyz", "--tool-radius", "10", "--corner-radius", "2", "-o", "a.csv"};
    call.insert(call.end(), more.begin(), more.end());
    return run(folder, call);
  };
  const RunResult refused = drive({"--scallop", "0.02"});
  ASSERT_EQ(refused.code, 1) << refused.out;
  const auto numberAfter = [&](const std::string& words) {
    const std::size_t at = refused.err.find(words);
    EXPECT_NE(at, std::string::npos) << words << " in " << refused.err;
    return at == std::string::npos ? 0.0 : std::strtod(refused.err.c_str() + at + words.size(), nullptr);
  };
  EXPECT_NEAR(numberAfter("up to "), 8.0 * 8.0 / 200.0, 0.05) << refused.err;
  EXPECT_EQ(drive({"--step-over", std::to_string(numberAfter("give --step-over "))}).code, 0);
  EXPECT_EQ(run(folder, {"hollow.xyz", "--tool-radius", "2", "--scallop", "0.02", "-o", "a.csv"}).code, 0) << "smaller cutter";
}

TEST(Drive, AReportInHtmlHasThePictures)
{
  const ScratchFolder folder;
  const std::vector<std::string> call{
      "cap.xyz", "--tool-radius", "4",  "--corner-radius", "1",         "--step-over",           "4", "--tolerance", "0.1",
      "-o",      "a.html",        "-o", "a.ngc",           "--machine", machines + "/xyzac.yaml"};
  if (std::getenv("DISPLAY")) {
    const RunResult done = run(folder, call);
    ASSERT_EQ(done.code, 0) << done.err;
    const std::string page = readText(folder.path("a.html"));
    std::size_t pictures = 0;
    for (std::size_t at = page.find("data:image/png;base64,"); at != std::string::npos; at = page.find("data:image/png;base64,", at + 1))
      ++pictures;
    EXPECT_EQ(pictures, 2U) << "passes, rotary axes";
    for (const char* words : {"<h1>cap.xyz</h1>", "corner 1 mm", "Machining time", "Warnings", "pcl_spiral_drive"})
      expectHas(page, words);
  }
  const char* const before = std::getenv("DISPLAY");
  const std::string kept = before ? before : "";
  ::unsetenv("DISPLAY");
  const RunResult blind = run(folder, {"cap.xyz", "--tool-radius", "4", "--step-over", "4", "-o", "b.html", "-o", "b.csv"});
  const RunResult plain = run(folder, {"cap.xyz", "--tool-radius", "4", "--step-over", "4", "-o", "b.json", "-o", "b.csv"});
  if (before)
    ::setenv("DISPLAY", kept.c_str(), 1);
  EXPECT_EQ(blind.code, 1);
  expectHas(blind.err, "b.html: this report needs pictures");
  expectHas(blind.err, "xvfb-run -a");
  EXPECT_EQ(plain.code, 0) << "the remedy: .json";
}

TEST(Drive, WrongCallsAreRefused)
{
  const ScratchFolder folder;
  const auto said = [&folder](const std::vector<std::string>& arguments, int code, const std::string& part) {
    const RunResult done = run(folder, arguments);
    EXPECT_EQ(done.code, code) << done.err;
    expectHas(done.err, part);
  };
  said({"cap.xyz", "-o", "a.csv", "--step-over", "1"}, 2, "no --tool-radius is given");
  said({"cap.xyz", "-o", "a.csv", "--tool-radius", "3"}, 2, "no --step-over is given");
  said({"cap.xyz", "--tool-radius", "3", "--step-over", "1"}, 2, "no output is given");
  said({"cap.xyz", "-o", "a.csv", "--tool-radius", "3", "--corner-radius", "4", "--step-over", "1"}, 2, "corner");
  said({"cap.xyz", "-o", "a.csv", "--tool-radius", "3", "--step-over", "1", "--scallop", "0.1"}, 2, "both given");
  said({"cap.xyz", "-o", "a.csv", "--tool-radius", "3", "--step-over", "1", "--holder", "5"}, 2, "--holder 5");
  said({"cap.xyz", "-o", "a.csv", "--tool-radius", "3", "--drive", "curve"}, 2, "no --curve is given");
  said({"cap.xyz", "-o", "a.csv", "--tool-radius", "3", "--step-over", "1", "--drive", "helix"}, 1, "cap.xyz: ");
  said({"cap.xyz", "-o", "a.csv", "--tool-radius", "3", "--step-over", "1", "--overrun", "2"}, 2,
       "--overrun: --drive planes does not use it");
  said({"cap.xyz", "-o", "a.csv", "--tool-radius", "3", "--step-over", "1", "--tolerance", "1e-7"}, 2, "0.0001 mm or more");
  said({"cap.xyz", "-o", "a.csv", "--tool-radius", "3", "--step-over", "1", "--holder-clearance", "2"}, 2, "no --holder is given");
  said({"cap.xyz", "-o", "a.csv", "--tool-radius", "3", "--rows", "kept", "--step-over", "1"}, 2, "no --scallop is given");
  said({"cap.xyz", "-o", "a.csv", "--tool-radius", "3", "--rows", "kept", "--scallop", "0.1", "--drive", "offset"}, 2,
       "--rows: --drive offset does not use it");
  said({"cap.xyz", "-o", "a.csv", "--tool-radius", "3", "--rows", "kept", "--scallop", "0.1", "--axis-mode", "cylinder"}, 2,
       "(--axis-mode)");
  said({"cap.xyz", "-o", "a.csv", "--tool-radius", "3", "--rows", "dense", "--scallop", "0.1"}, 2, "even");
  said({"cap.xyz", "-o", "a.csv", "--tool-radius", "3", "--step-over", "1", "--link", "--one-way"}, 2, "leave --one-way");
  said({"cap.xyz", "-o", "a.csv", "--tool-radius", "3", "--step-over", "1", "--link", "--drive", "rings"}, 2,
       "--link: --drive rings does not use it");
  for (const char* output : {"a.pcd", "a.ply"})
    said({"cap.xyz", "-o", output, "--tool-radius", "3", "--corner-radius", "1", "--step-over", "1"}, 2, "only for a ball");
  writeText(folder.path("job.yaml"), "tool-radius: 3\nstep-over: 1\none-way: perhaps\n");
  said({"cap.xyz", "-o", "a.csv", "--config", "job.yaml"}, 2, "must be true or false");
  writeText(folder.path("machine.yaml"), readText(machines + "/xyzac.yaml"));
  said({"cap.xyz", "-o", "machine.yaml", "-o", "a.ngc", "--tool-radius", "3", "--step-over", "1", "--machine", "machine.yaml"}, 2,
       "this is the machine's file itself");
  said({"cap.xyz", "-o", "a.csv", "--tool-radius", "3", "--step-ove", "1"}, 2, "did you mean 'step-over'?");
  EXPECT_FALSE(std::filesystem::exists(folder.path("a.csv")));
}

TEST(Drive, LinksStayDownWhereTheWayIsFree)
{
  const ScratchFolder folder;
  const std::vector<std::string> call{"--tool-radius", "3",  "--step-over", "1.5", "--stay-down", "10",        "-o",
                                      "a.ngc",         "-o", "a.json",      "-o",  "a.csv",       "--machine", machines + "/xyzac.yaml"};
  const auto drive = [&](const std::string& scan) {
    std::vector<std::string> arguments = call;
    arguments.insert(arguments.begin(), scan);
    return run(folder, arguments);
  };
  const auto count = [&folder](const std::string& part) {
    const std::string text = readText(folder.path("a.ngc"));
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
      ++found;
    return found;
  };
  const RunResult open = drive("cap.xyz");
  ASSERT_EQ(open.code, 0) << open.err;
  const auto begins = passBegins(readText(folder.path("a.csv")));
  expectHas(open.out, "links           " + std::to_string(begins.size()) + " near the surface, 0 not free: the tool retracts");
  EXPECT_EQ(count("(link to the next pass)"), begins.size());
  EXPECT_EQ(count("(end of the link)"), begins.size());
  expectHas(readText(folder.path("a.json")), "\"blocked_links\": 0");
  const std::string canon = "export HOME='" + folder.root().string() + "'; cd '" + machines + "/rs274' && rs274 -i rs274.ini -g '" +
                            folder.path("a.ngc") + "' '" + folder.path("canon.txt") + "' 2>'" + folder.path("messages.txt") + "'";
  ASSERT_EQ(std::system(canon.c_str()), 0) << readText(folder.path("messages.txt"));

  // A post 4.4 mm from the axis at the end of a row: rows and leads pass, the link comes nearer than the radius and 1 mm.
  const auto end = rows(readText(folder.path("a.csv")))[begins[begins.size() / 2] - 1];
  const double away = 1.0 + 4.4 / std::hypot(end[8], end[9]);
  std::ostringstream post;
  for (int i = 0; i < 8; ++i)
    post << away * end[8] << ' ' << away * end[9] << ' ' << end[10] + 1.0 + i << '\n';
  writeText(folder.path("post.xyz"), readText(folder.path("cap.xyz")) + post.str());
  const RunResult blocked = drive("post.xyz");
  ASSERT_EQ(blocked.code, 0) << blocked.err;
  // The post widens the scan, so its rows are others than those of the cap; beside it one link is longer than 10 mm.
  const std::size_t links = count("(link to the next pass)"), ways = passBegins(readText(folder.path("a.csv"))).size();
  EXPECT_LT(links, ways);
  EXPECT_GT(links + 5, ways);
  std::size_t near = 0, not_free = 0;
  ASSERT_EQ(std::sscanf(blocked.out.c_str() + blocked.out.find("links  "), "links %zu near the surface, %zu not free", &near, &not_free),
            2);
  EXPECT_EQ(near, links);
  EXPECT_GE(not_free, 1u);
  EXPECT_LE(near + not_free, ways);
  const RunResult judged = endOf(startProgram(PCL_SPIRAL_VERIFY_PROGRAM,
                                              {"post.xyz", "a.ngc", "--tool-radius", "3", "--scallop", "0.1", "--machine",
                                               machines + "/xyzac.yaml", "-o", "judged.json"},
                                              folder),
                                 folder);
  EXPECT_EQ(judged.code, 0) << judged.out << judged.err;
  expectHas(judged.out, "0 of these collide");
  const std::string report = readText(folder.path("judged.json")), key = "\"passes\": ";
  ASSERT_NE(report.find(key), std::string::npos);
  const auto passes = static_cast<std::size_t>(std::atoi(report.c_str() + report.find(key) + key.size()));
  EXPECT_GE(passes, ways) << "one pass lies on the post alone, where no surface is cut";
  EXPECT_LE(passes, ways + 1);
  const RunResult refused = run(folder, {"cap.xyz", "--tool-radius", "3", "--step-over", "1.5", "--stay-down", "10", "-o", "b.csv"});
  EXPECT_EQ(refused.code, 2);
  expectHas(refused.err, "--stay-down: no output is a program");
}

} // namespace drive_test
