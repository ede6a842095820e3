// SPDX-License-Identifier: BSD-3-Clause
// Programs read from their text by the tests alone: the tool, moved as the machine moves it, takes stock from rays over the exact
// surface. What is left and what is cut too deep are as planned; a fault in the program or the machine is found.
#include "command_line/run_program.h"
#include "support/cut_rays.h"
#include "support/gcode_way.h"
#include "support/sampling.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <iomanip>
#include <map>
#include <memory>
#include <regex>
#include <sstream>

namespace program_stock_test {

using namespace pcl_spiral::test;
using Eigen::Vector3d;

namespace {

using Arguments = std::vector<std::string>;
using Lines = std::vector<std::string>;

const std::string machines = PCL_SPIRAL_MACHINES_DIR;
constexpr double scallop = 0.05, chord = 0.005; // asked of the programs, mm
constexpr double block = 0.002;                 // tolerance of blocks, by default
constexpr double deepest = 0.2, reach = 0.2;    // of the rays

/** Each machine as the comments of its file describe it, and the control of a dialect. */
const ControlledMachine xyzac{{{{'C', true, Vector3d::UnitZ(), {0, 0, 0}}, {'A', true, Vector3d::UnitX(), {0, 20, 10}}}, {0, 0, 40}, 0.0},
                              TipControl::Kinematics};
const ControlledMachine fork_head{
    {{{'C', false, Vector3d::UnitZ(), {0, 0, 0}}, {'B', false, Vector3d::UnitY(), {0, 0, 150}}}, {0, 0, 100}, 120.0}, TipControl::Length};
const ControlledMachine swivel_head{
    {{{'C', true, Vector3d::UnitZ(), {0, 0, 0}}, {'B', false, Vector3d::UnitY(), {0, 0, 120}}}, {0, 0, 60}, 150.0}, TipControl::Never};

const ControlledMachine three_axes{{{}, {0, 0, -300}, 80.0}, TipControl::Never};

const RoundedCutter ball_nose{4.0, 4.0, 10.0}, bull_nose{4.0, 1.0, 10.0};

class ProgramStock : public ::testing::Test {
protected:
  /** Scans of a dome and of a saddle, and the programs that get faults. */
  static void SetUpTestSuite()
  {
    folder_ = std::make_unique<ScratchFolder>();
    surfaces_["dome"] = ball(60.0, Region({circle({0.0, 0.0}, 10.0, 256)}));
    surfaces_["saddle"] = quadric(70.0, -50.0, Region({rectangle(18.0, 14.0)}));
    for (const auto& [name, surface] : surfaces_) {
      std::ostringstream text;
      text << std::setprecision(9);
      for (const Vector3d& p : sampleUniform(*surface, 3000, 4).points)
        text << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
      writeText(folder_->path(name + ".xyz"), text.str());
    }
    tables_ = spiral("dome", "xyzac.yaml", "linuxcnc");
    head_over_table_ = spiral("saddle", "head_table.yaml", "fanuc");
  }
  static void TearDownTestSuite()
  {
    folder_.reset();
    surfaces_.clear();
  }

  static std::string made(const std::string& program, const std::string& part, const std::string& machine, const std::string& dialect,
                          const Arguments& more)
  {
    Arguments arguments{part + ".xyz",
                        "--tool-radius",
                        "4",
                        "--scallop",
                        std::to_string(scallop),
                        "--machine",
                        machines + "/" + machine,
                        "--dialect",
                        dialect,
                        "--tool",
                        "3",
                        "-o",
                        "part.nc",
                        "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    std::fflush(stdout); // the program's process has a copy of what is not written yet
    const RunResult result = endOf(startProgram(program, arguments, *folder_), *folder_);
    EXPECT_EQ(result.code, 0) << result.err;
    return readText(folder_->path("part.nc"));
  }

  /** A spiral of the ball, its axis tilted. */
  static std::string spiral(const std::string& part, const std::string& machine, const std::string& dialect)
  {
    return made(PCL_SPIRAL_TOOLPATH_PROGRAM, part, machine, dialect, {"--tilt", "12", "--chord-error", std::to_string(chord)});
  }

  /** Rows of the bull-nose along planes. */
  static std::string rows(const std::string& part, const std::string& machine, const std::string& axis)
  {
    return made(PCL_SPIRAL_DRIVE_PROGRAM, part, machine, "linuxcnc",
                {"--corner-radius", "1", "--flank-length", "16", "--axis", axis, "--tolerance", std::to_string(chord)});
  }

  static CutReport cutBy(const std::string& text, const std::string& part, const ControlledMachine& machine, const RoundedCutter& cutter)
  {
    constexpr double ray = 0.15, step = 0.1, band = 0.35; // the points of the scans are 0.33 mm apart
    CutRays rays(*surfaces_.at(part), ray, deepest, reach);
    followMoves(movesOf(text, machine), machine, step, [&](const TipAndAxis& place) { rays.cut(cutter, place); });
    return rays.figures(band);
  }

  static inline std::unique_ptr<ScratchFolder> folder_;
  static inline std::map<std::string, SurfacePtr> surfaces_;
  static inline std::string tables_, head_over_table_; ///< spirals over the dome and over the saddle
};

/** What is not as planned; empty if nothing. */
std::string
faultOf(const CutReport& f)
{
  std::printf("  %zu rays: cut %.4f mm too deep, up to %.4f mm left on 98 %%, %.4f mm at most\n", f.rays, f.gouge, f.high, f.most);
  return f.gouge > chord + block          ? "cut too deep"
         : f.high > 1.1 * scallop + chord ? "left too high"
         : f.most >= reach                ? "left uncut"
         : f.most < 0.8 * scallop         ? "cut more often than asked"
                                          : "";
}

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

/** The line in the middle of the program. */
Lines::iterator
middleOf(Lines& lines)
{
  return lines.begin() + static_cast<std::ptrdiff_t>(lines.size() / 2);
}

} // namespace

TEST_F(ProgramStock, ABallLeavesAndCutsWhatWasPlannedOnEveryKindOfMachine)
{
  EXPECT_EQ(faultOf(cutBy(tables_, "dome", xyzac, ball_nose)), "");
  EXPECT_EQ(faultOf(cutBy(spiral("saddle", "head_head.yaml", "fanuc"), "saddle", fork_head, ball_nose)), "");
  EXPECT_EQ(faultOf(cutBy(head_over_table_, "saddle", swivel_head, ball_nose)), "");
}

TEST_F(ProgramStock, ABullNoseLeavesAndCutsWhatWasPlannedWithThreeAxesAndTilted)
{
  EXPECT_EQ(faultOf(cutBy(rows("dome", "xyzac.yaml", "0,0.2,1"), "dome", xyzac, bull_nose)), "");
  EXPECT_EQ(faultOf(cutBy(rows("saddle", "three_axes.yaml", "0,0,1"), "saddle", three_axes, bull_nose)), "");
}

TEST_F(ProgramStock, FaultsOfTheMachineAreFound)
{
  const auto fault = [&](const auto& change) {
    ControlledMachine machine = xyzac;
    change(machine);
    return faultOf(cutBy(tables_, "dome", machine, ball_nose));
  };
  EXPECT_EQ(fault([](ControlledMachine&) {}), "");
  EXPECT_EQ(fault([](ControlledMachine& m) { m.longer_tool = 1.0; }), "cut too deep");
  EXPECT_NE(fault([](ControlledMachine& m) { m.longer_tool = -1.0; }), "");
  EXPECT_EQ(fault([](ControlledMachine& m) { m.chain.rotary[1].direction = Vector3d::UnitY(); }), "cut too deep") << "B for A";
  EXPECT_EQ(fault([](ControlledMachine& m) { m.chain.rotary[1].direction *= -1.0; }), "cut too deep");
  EXPECT_EQ(fault([](ControlledMachine& m) { m.chain.rotary[0].direction *= -1.0; }), "cut too deep");
  EXPECT_NE(fault([](ControlledMachine& m) { m.tip_control = TipControl::Never; }), "");
}

TEST_F(ProgramStock, FaultsOfTheProgramAreFound)
{
  const auto fault = [&](const auto& change) {
    Lines lines = linesOf(head_over_table_);
    change(lines);
    return faultOf(cutBy(textOf(lines), "saddle", swivel_head, ball_nose));
  };
  const auto replaced = [](const std::string& what, const std::string& with) {
    return [what, with](Lines& lines) {
      for (std::string& line : lines)
        line = std::regex_replace(line, std::regex(what), with);
    };
  };
  EXPECT_EQ(fault([](Lines&) {}), "");
  EXPECT_NE(fault(replaced(" B(\\S+) C(\\S+)", " C$1 B$2")), "") << "angles of the other axis";
  EXPECT_NE(fault(replaced(" B-?", " B-")), "") << "wrong sign";
  EXPECT_NE(fault([](Lines& lines) { lines.erase(middleOf(lines), middleOf(lines) + 40); }), "") << "blocks missing";
  EXPECT_EQ(fault([](Lines& lines) { lines.insert(middleOf(lines), "G0 Z-30.0"); }), "cut too deep") << "a rapid through the part";
  EXPECT_THROW(fault(replaced("^G1", "G2")), std::runtime_error);
}

} // namespace program_stock_test
