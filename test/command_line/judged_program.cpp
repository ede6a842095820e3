// SPDX-License-Identifier: BSD-3-Clause
// Programs judged by pcl_spiral_verify from their text and the scan alone: sound ones keep their limits, planted faults are found.
#include "cap_scan.h"
#include "run_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iomanip>
#include <memory>
#include <regex>
#include <sstream>

namespace judged_program_test {

namespace {

using Arguments = std::vector<std::string>;
using Lines = std::vector<std::string>;

const std::string machines = PCL_SPIRAL_MACHINES_DIR;

Lines
linesOf(const std::string& text)
{
  std::istringstream stream(text);
  Lines lines;
  for (std::string line; std::getline(stream, line);)
    lines.push_back(line);
  return lines;
}

std::string
textOf(const Lines& lines)
{
  std::string text;
  for (const std::string& line : lines)
    text += line + "\n";
  return text;
}

/** The number after \p letter in a line of words. */
double
value(const std::string& line, char letter)
{
  return std::stod(line.substr(line.find(std::string(" ") + letter) + 2));
}

std::string
fixedText(double number)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(4) << number;
  return text.str();
}

std::string
withValue(const std::string& line, char letter, double number)
{
  return std::regex_replace(line, std::regex(std::string(" ") + letter + "-?[0-9.]+"), std::string(" ") + letter + fixedText(number));
}

class JudgedProgram : public ::testing::Test {
protected:
  /** The scan, its spiral with tilted axes and its rows, made once. */
  static void SetUpTestSuite()
  {
    made_ = std::make_unique<ScratchFolder>();
    writeText(made_->path("cap.xyz"), capScan(8000));
    make(PCL_SPIRAL_TOOLPATH_PROGRAM, {"--scallop", "0.02", "--tilt", "10", "-o", "part.ngc", "-o", "part.apt", "-o", "part.json",
                                       "--machine", machines + "/xyzac.yaml"});
    make(PCL_SPIRAL_TOOLPATH_PROGRAM, {"--scallop", "0.02", "--axis", "0,0,1", "--feed", "10000", "-o", "fast.ngc", "-o", "fast.json",
                                       "--machine", machines + "/three_axes.yaml"});
    for (const std::string dialect : {"fanuc", "fanuc-ijk", "siemens", "heidenhain"})
      make(PCL_SPIRAL_TOOLPATH_PROGRAM, {"--scallop", "0.02", "--tool", "3", "-o", dialect + ".nc", "--dialect", dialect, "--machine",
                                         machines + (dialect == "fanuc-ijk" ? "/xyzac.yaml" : "/head_head.yaml")}); // it cannot unwind C
    make(PCL_SPIRAL_DRIVE_PROGRAM, {"--step-over", "0.6", "--tolerance", "0.005", "--one-way", "-o", "rows.ngc", "-o", "rows.apt",
                                    "--machine", machines + "/xyzac.yaml"});
    make(PCL_SPIRAL_DRIVE_PROGRAM, {"--step-over", "0.6", "--tolerance", "0.005", "--one-way", "-o", "alone.apt"});
  }
  static void TearDownTestSuite() { made_.reset(); }
  void SetUp() override { std::filesystem::copy(made_->root(), folder_.root()); }

  static void make(const std::string& program, Arguments arguments)
  {
    arguments.insert(arguments.begin(), {"cap.xyz", "--tool-radius", "3"});
    const RunResult result = endOf(startProgram(program, arguments, *made_), *made_);
    ASSERT_EQ(result.code, 0) << result.err;
  }

  RunResult verify(const std::string& file, const std::string& machine = machines + "/xyzac.yaml", const Arguments& more = {})
  {
    Arguments arguments{"cap.xyz", file, "--tool-radius", "3", "--scallop", "0.02"};
    if (!machine.empty())
      arguments.insert(arguments.end(), {"--machine", machine});
    arguments.insert(arguments.end(), more.begin(), more.end());
    return endOf(startProgram(PCL_SPIRAL_VERIFY_PROGRAM, arguments, folder_), folder_);
  }

  RunResult judge(const std::string& file, const std::string& machine = machines + "/xyzac.yaml")
  {
    return verify(file, machine, {"--max-gouge", "0.008", "--max-scallop", "0.026", "--max-deviation", "0.008", "--max-uncut", "0"});
  }

  /** part.ngc after \p change of its lines, judged. */
  RunResult spoilt(const std::function<void(Lines&)>& change)
  {
    Lines lines = linesOf(readText(folder_.path("part.ngc")));
    change(lines);
    writeText(folder_.path("spoilt.ngc"), textOf(lines));
    return judge("spoilt.ngc");
  }

  static inline std::unique_ptr<ScratchFolder> made_;
  ScratchFolder folder_;
};

bool
isMove(const std::string& line)
{
  return line[0] == 'G' && line.find(" X") != std::string::npos;
}

void
expectHas(const std::string& text, const std::string& part)
{
  EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' in: " << text;
}

} // namespace

TEST_F(JudgedProgram, SoundProgramsOfEveryLanguageKeepTheirLimits)
{
  for (const auto& [file, machine] : std::vector<std::pair<std::string, std::string>>{{"part.ngc", machines + "/xyzac.yaml"},
                                                                                      {"part.apt", ""},
                                                                                      {"part.apt", machines + "/xyzac.yaml"},
                                                                                      {"fanuc.nc", machines + "/head_head.yaml"},
                                                                                      {"fanuc-ijk.nc", machines + "/xyzac.yaml"},
                                                                                      {"siemens.nc", machines + "/head_head.yaml"},
                                                                                      {"heidenhain.nc", machines + "/head_head.yaml"}}) {
    const RunResult result = judge(file, machine);
    EXPECT_EQ(result.code, 0) << file << result.out << result.err;
    expectHas(result.out, "0 of these collide");
  }
}

TEST_F(JudgedProgram, WithoutRtcpTheAxesOfTheMachineAreFollowed)
{
  std::string text = readText(machines + "/head_head.yaml");
  text.replace(text.find("rtcp: true"), 10, "rtcp: false");
  writeText(folder_.path("plain.yaml"), text);
  const RunResult made =
      endOf(startProgram(PCL_SPIRAL_TOOLPATH_PROGRAM,
                         {"cap.xyz", "--tool-radius", "3", "--scallop", "0.02", "-o", "plain.ngc", "--machine", "plain.yaml"}, folder_),
            folder_);
  ASSERT_EQ(made.code, 0) << made.err;
  EXPECT_EQ(judge("plain.ngc", "plain.yaml").code, 0);
  const RunResult other = judge("plain.ngc", machines + "/head_head.yaml");
  EXPECT_EQ(other.code, 1);
  expectHas(other.err, "line 2: the comment says that the program was made for");
}

TEST_F(JudgedProgram, FindsAWrongSignOfA)
{
  const RunResult result = spoilt([](Lines& lines) {
    for (std::string& line : lines)
      if (line.find(" A") != std::string::npos && line[0] == 'G')
        line = withValue(line, 'A', -value(line, 'A'));
  });
  EXPECT_EQ(result.code, 1) << result.out;
  expectHas(result.out, "LIMIT           --max-gouge");
}

TEST_F(JudgedProgram, FindsATenthOfAMillimetreOfToolLength)
{
  for (double off : {-0.1, 0.1}) {
    const RunResult result = spoilt([off](Lines& lines) {
      for (std::string& line : lines)
        if (isMove(line)) { // the tip along the tool axis, which tables A and C turn to (sin C sin A, cos C sin A, cos A)
          const double a = value(line, 'A') * M_PI / 180.0, c = value(line, 'C') * M_PI / 180.0;
          const double axis[3] = {std::sin(c) * std::sin(a), std::cos(c) * std::sin(a), std::cos(a)};
          for (int i = 0; i < 3; ++i)
            line = withValue(line, "XYZ"[i], value(line, "XYZ"[i]) + off * axis[i]);
        }
    });
    EXPECT_EQ(result.code, 1) << result.out;
    expectHas(result.out, "LIMIT           --max-deviation");
    const std::string broken = result.out.substr(result.out.find("--max-deviation 0.008 is broken: ") + 33);
    EXPECT_NEAR(std::stod(broken), 0.1, 0.015) << broken; // along a tilted axis
    if (off < 0.0)
      expectHas(result.out, "LIMIT           --max-gouge");
  }
}

TEST_F(JudgedProgram, AnEdgeIsNoMissingBlock)
{
  std::ostringstream plate; // 8 mm wide and 1 mm high, on a dome
  for (int i = -25; i <= 25; ++i)
    for (int k = -25; k <= 25; ++k) {
      const double x = 0.8 * i + 0.1 * std::sin(7.0 * i + 3.0 * k), y = 0.8 * k + 0.1 * std::sin(5.0 * i - 4.0 * k);
      const bool on = std::abs(x - 3.0) < 4.0 && std::abs(y) < 4.0;
      if (std::hypot(x, y) < 20.0)
        plate << x << ' ' << y << ' ' << (on ? 1.0 : -(x * x + y * y) / 240.0) << '\n';
    }
  writeText(folder_.path("plate.xyz"), plate.str());
  for (const std::string tilt : {"0", "8"}) {
    const Arguments common{"--tool-radius", "4", "--scallop", "0.05", "--machine", machines + "/xyzac.yaml"};
    Arguments make{"plate.xyz", "--tilt", tilt, "-o", "plate.ngc"}, judge{"plate.xyz", "plate.ngc"};
    make.insert(make.end(), common.begin(), common.end());
    judge.insert(judge.end(), common.begin(), common.end());
    const RunResult made = endOf(startProgram(PCL_SPIRAL_TOOLPATH_PROGRAM, make, folder_), folder_);
    ASSERT_EQ(made.code, 0) << made.err;
    EXPECT_NE(made.err.find("over the fitted surface"), std::string::npos) << made.err;
    const RunResult judged = endOf(startProgram(PCL_SPIRAL_VERIFY_PROGRAM, judge, folder_), folder_);
    EXPECT_EQ(judged.err.find("times as fast"), std::string::npos) << tilt << ": " << judged.err;
  }
}

TEST_F(JudgedProgram, FindsAMissingBlockByItsLine)
{
  for (std::size_t missing : {3000, 9000, 15000}) {
    for (std::ptrdiff_t count : {1, 12}) { // a few moves on this dome are within the chord error of the moves beside them
      const RunResult result = spoilt([missing, count](Lines& lines) {
        const auto begin = lines.begin() + static_cast<std::ptrdiff_t>(missing - 1);
        lines.erase(begin, begin + count);
      });
      expectHas(result.err, "line " + std::to_string(missing) + ": the cutter moves ");
      EXPECT_EQ(result.code, count > 1 ? 1 : 0) << result.out;
      if (count == 1)
        continue;
      const std::string broken = result.out.substr(std::min(result.out.size(), result.out.find("LIMIT           --max-gouge")));
      EXPECT_NEAR(std::stod("0" + broken.substr(std::min(broken.size(), broken.find("line ") + 5))), static_cast<double>(missing), 1.0)
          << result.out;
    }
  }
  Lines lines = linesOf(readText(folder_.path("heidenhain.nc")));
  lines.erase(lines.begin() + 200);
  writeText(folder_.path("spoilt.nc"), textOf(lines));
  expectHas(judge("spoilt.nc", machines + "/head_head.yaml").err,
            "line 201: the line has the number 201, and 200 follows: a block is missing");
}

TEST_F(JudgedProgram, FindsARapidThroughThePart)
{
  std::size_t at = 0;
  const RunResult result = spoilt([&at](Lines& lines) {
    while (lines[at].rfind("G0 X", 0) != 0)
      ++at;
    lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(at), "G0 X80 Y0 Z-20 A0 C0");
    lines[at + 1] = "G0 X-80 Y0 Z-20 A0 C0";
  });
  EXPECT_EQ(result.code, 1) << result.out;
  expectHas(result.out, "LIMIT           line " + std::to_string(at + 2) + ": on this rapid move ");
  expectHas(result.out, " deep in the scan at ");
}

TEST_F(JudgedProgram, TheWayBetweenRowsIsNoCutUntilItsRapidsAreLow)
{
  const RunResult sound = verify("rows.ngc", machines + "/xyzac.yaml", {"--max-gouge", "0.008", "--max-deviation", "0.008"});
  EXPECT_EQ(sound.code, 0) << sound.out << sound.err;
  expectHas(sound.out, "between passes");
  Lines lines = linesOf(readText(folder_.path("rows.ngc")));
  std::size_t rapids = 0;
  for (std::string& line : lines) // over a row in the middle
    if (line.rfind("G0 X", 0) == 0 && ++rapids >= 330 && rapids < 335)
      line = withValue(line, 'Z', -9.0);
  writeText(folder_.path("spoilt.ngc"), textOf(lines));
  const RunResult result = verify("spoilt.ngc");
  expectHas(result.out, ": on this rapid move ");
  EXPECT_EQ(result.code, 1) << result.out << result.err;
}

TEST_F(JudgedProgram, CldataOfSeveralPassesIsJudgedAsTheProgramIs)
{
  const auto figuresOf = [this](const std::string& file, const std::string& machine) {
    const RunResult result = verify(file, machine, {"--max-gouge", "0.008", "--max-deviation", "0.008", "-o", "figures.json"});
    EXPECT_EQ(result.code, 0) << file << result.out << result.err;
    expectHas(result.out, "0 of these collide");
    return nlohmann::json::parse(readText(folder_.path("figures.json")))["paths"][0];
  };
  const auto program = figuresOf("rows.ngc", machines + "/xyzac.yaml");
  const std::size_t passes = program["program"]["passes"];
  EXPECT_GT(passes, 20U);
  for (const auto& [file, machine] :
       std::vector<std::pair<std::string, std::string>>{{"rows.apt", ""}, {"rows.apt", machines + "/xyzac.yaml"}, {"alone.apt", ""}}) {
    const auto figures = figuresOf(file, machine);
    EXPECT_EQ(figures["program"]["passes"], passes) << file;
    EXPECT_NEAR(figures["deviation"]["rms"].get<double>(), program["deviation"]["rms"].get<double>(),
                4e-5); // the program has four decimals: 1e-4 / sqrt(12)
  }
  Lines lines = linesOf(readText(folder_.path("alone.apt")));
  const auto middle = static_cast<std::size_t>(std::count(lines.begin(), lines.end(), "RAPID")) / 2;
  std::size_t rapids = 0;
  bool low = false;
  for (std::string& line : lines) { // across a row in the middle
    if (low)
      line = std::regex_replace(line, std::regex("^(GOTO/[^,]*,[^,]*),[^,]*"), "$1,-9.0");
    low = line == "RAPID" && ++rapids >= middle && rapids < middle + 5;
  }
  writeText(folder_.path("spoilt.apt"), textOf(lines));
  const RunResult result = verify("spoilt.apt", "");
  expectHas(result.out, ": on this rapid move ");
  EXPECT_EQ(result.code, 1) << result.out << result.err;
}

TEST_F(JudgedProgram, LinesOfTheProgramAreInTheJson)
{
  EXPECT_EQ(verify("part.ngc", machines + "/xyzac.yaml", {"-o", "figures.json"}).code, 0);
  const auto path = nlohmann::json::parse(readText(folder_.path("figures.json")))["paths"][0];
  const std::size_t lines = linesOf(readText(folder_.path("part.ngc"))).size();
  EXPECT_GT(path["material"]["gouge"]["line"], 8);
  EXPECT_LT(path["material"]["gouge"]["line"], lines);
  EXPECT_EQ(path["program"]["passes"], 1);
  EXPECT_GT(path["program"]["blocks"], lines - 25);
}

TEST_F(JudgedProgram, TheMachiningTimeOfTheTextIsThatOfThePlan)
{
  const auto secondsOf = [this](const std::string& program, const std::string& machine) {
    const RunResult result = verify(program, machines + machine, {"-o", "figures.json"});
    EXPECT_EQ(result.code, 0) << result.err;
    expectHas(result.out, " on LinuxCNC");
    return nlohmann::json::parse(readText(folder_.path("figures.json")))["paths"][0]["program"]["motion"]["seconds"].get<double>();
  };
  const auto planned = [this](const std::string& report) {
    return nlohmann::json::parse(readText(folder_.path(report)))["motion"]["seconds"].get<double>();
  };
  EXPECT_NEAR(secondsOf("part.ngc", "/xyzac.yaml"), planned("part.json"), 0.01 * planned("part.json"));
  const double fast = planned("fast.json");
  EXPECT_NEAR(secondsOf("fast.ngc", "/three_axes.yaml"), fast, 0.01 * fast);
  Lines lines = linesOf(readText(folder_.path("fast.ngc")));
  const auto smooths = std::find_if(lines.begin(), lines.end(), [](const std::string& line) { return line.rfind("G64 P", 0) == 0; });
  ASSERT_NE(smooths, lines.end());
  const auto with = [&](const std::string& words) {
    *smooths = words;
    writeText(folder_.path("other.ngc"), textOf(lines));
    return secondsOf("other.ngc", "/three_axes.yaml");
  };
  const double wide = with("G64 P0.5"), free = with("G64"), exact = with("G61");
  EXPECT_LT(wide, fast) << "the tolerance is that of the text";
  EXPECT_LE(free, wide);
  EXPECT_GT(exact, 1.5 * fast) << "it stops at every corner";
  const RunResult apt = verify("part.apt", "", {"-o", "figures.json"});
  EXPECT_EQ(apt.out.find("on the control"), std::string::npos) << "no control is known that reads APT";
}

TEST_F(JudgedProgram, WhatCannotBeJudgedIsRefusedWithTheRemedy)
{
  const RunResult none = judge("part.ngc", "");
  EXPECT_EQ(none.code, 2);
  expectHas(none.err, "part.ngc: a program has the axes of a machine; give its machine file, such as --machine xyzac.yaml");
  const RunResult other = judge("part.ngc", machines + "/xyzbc.yaml");
  EXPECT_EQ(other.code, 1);
  expectHas(other.err, "part.ngc: line 2: ");
  expectHas(other.err, "give the machine file for which it was made");
  const RunResult arc = spoilt([](Lines& lines) { lines[20] = "G2 X1 Y1 I1 J0"; });
  EXPECT_EQ(arc.code, 1);
  expectHas(arc.err, "spoilt.ngc: line 21: G2: an arc; write straight moves (G0, G1)");
  const RunResult high = spoilt([](Lines& lines) {
    for (std::string& line : lines)
      if (isMove(line))
        line = withValue(line, 'Z', value(line, 'Z') + 30.0);
  });
  EXPECT_EQ(high.code, 1);
  expectHas(high.err, "above the scan on all of its feed moves");
  expectHas(verify("part.ngc", machines + "/xyzac.yaml", {"--mesh"}).err, "programs are judged by a scan; leave --mesh out");
}

} // namespace judged_program_test
