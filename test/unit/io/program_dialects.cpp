// SPDX-License-Identifier: BSD-3-Clause
// Every language of programs and paths, read back by parsers of the tests and checked with kinematics of the
// tests.
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/path_exchange.h>
#include <pcl_spiral/io/program_reader.h>
#include <pcl_spiral/io/program_writer.h>
#include <pcl_spiral/machine/machine_program_generator.h>

#include "core/angle_between.h"
#include "support/dome_spiral.h"
#include "support/parsed_place.h"
#include "support/scratch_folder.h"
#include "support/shortest_block.h"
#include "support/test_machines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <locale>
#include <regex>

namespace program_dialects_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

const double ball = 6.0;

ToolPoses
testPath()
{
  return domeSpiral(200.0, 2.0, 20, 60, ball, 13.0);
}

MachineProgram
programFor(const Machine& machine, const ToolPoses& poses)
{
  MachineProgramGenerator generator;
  generator.setMachine(machine);
  generator.setInputPoses(poses);
  ProgramSettings settings;
  settings.ball_radius = ball;
  generator.setSettings(settings);
  MachineProgram program;
  generator.compute(program);
  EXPECT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
  return program;
}

/** The program passes every pose after the zone of the pole in order, within 1e-3 mm and 1e-3 degree; the times are those
 * of the program. */
void
expectPath(const Machine& machine, const ParsedProgram& parsed, const MachineProgram& program, const ToolPoses& poses, Dialect dialect)
{
  ASSERT_EQ(parsed.moves.size(), program.blocks.size());
  std::size_t at = 0;
  const std::size_t begin = program.report.poles.empty() ? 0 : program.report.poles.back().last_pose + 1;
  for (std::size_t i = begin; i < poses.size(); ++i) {
    for (; at < parsed.moves.size(); ++at) {
      const TipAndAxis found = where(machine, parsed.moves[at]);
      if ((found.tip - poses[i].tip).norm() < 1e-3 && angleBetween(found.axis, poses[i].axis) < 1e-3 * M_PI / 180.0)
        break;
    }
    ASSERT_LT(at, parsed.moves.size()) << machine.name << ": pose " << i << " is not on the program's way";
  }
  double minutes = 0.0, slower = 0.0;
  for (std::size_t i = 0; i < parsed.moves.size(); ++i) {
    ASSERT_EQ(parsed.moves[i].rapid, program.blocks[i].rapid);
    if (!parsed.moves[i].rapid)
      ASSERT_NEAR(parsed.moves[i].minutes / std::max(program.blocks[i].minutes, shortestBlock(dialect)), 1.0, 0.01) << i;
    minutes += parsed.moves[i].minutes;
    slower += parsed.moves[i].rapid ? 0.0 : std::max(0.0, shortestBlock(dialect) - program.blocks[i].minutes);
  }
  EXPECT_NEAR(minutes / (program.report.minutes + slower), 1.0, 1e-3);
}

/** A locale that writes 1.234,5. */
class CommaPoint : public std::numpunct<char> {
protected:
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

} // namespace

TEST(ProgramDialects, EveryLanguageSaysThePath)
{
  const ScratchFolder folder;
  const ToolPoses poses = testPath();
  const std::string file = folder.path("part.nc");
  for (const Machine& machine : testMachines()) {
    const MachineProgram program = programFor(machine, poses);
    const ProgramHeader header{"part.pcd", 12000.0, 3, 4};
    writeProgram(file, program, Dialect::LinuxCNC, header);
    ParsedProgram parsed = parseFanuc(file);
    expectPath(machine, parsed, program, poses, Dialect::LinuxCNC);
    for (const char* line : {"G21 G90 G17 G40 G80 G94", "G64 P0.010000", "T3 M6", "G43", "S12000 M3", "G93", "G94", "M2"})
      EXPECT_TRUE(parsed.has(line)) << line;
    MachineProgram exact = program;
    exact.machine.path_tolerance = 0.0;
    writeProgram(file, exact, Dialect::LinuxCNC, header);
    EXPECT_TRUE(parseFanuc(file).has("G61"));
    writeProgram(file, program, Dialect::Fanuc, header);
    parsed = parseFanuc(file);
    expectPath(machine, parsed, program, poses, Dialect::Fanuc);
    EXPECT_EQ(parsed.others.front(), "%");
    EXPECT_EQ(parsed.others.back(), "%");
    EXPECT_TRUE(parsed.has("M30"));
    EXPECT_EQ(
        std::count_if(parsed.others.begin(), parsed.others.end(), [](const std::string& line) { return line.rfind("G43.4 H3 X", 0) == 0; }),
        1);
    writeProgram(file, program, Dialect::FanucVectors, header);
    parsed = parseFanuc(file);
    expectPath(machine, parsed, program, poses, Dialect::FanucVectors);
    EXPECT_TRUE(std::all_of(parsed.moves.begin(), parsed.moves.end(),
                            [](const ParsedMove& m) { return m.vector.has_value() && m.degrees.empty(); }));
    writeProgram(file, program, Dialect::Siemens, header);
    parsed = parseSiemens(file);
    expectPath(machine, parsed, program, poses, Dialect::Siemens);
    for (const char* line : {"TRAORI", "ORIWKS", "ORIVECT", "TRAFOOF", "G93", "M30"})
      EXPECT_TRUE(parsed.has(line)) << line;
    writeProgram(file, program, Dialect::Heidenhain, header);
    parsed = parseHeidenhain(file);
    expectPath(machine, parsed, program, poses, Dialect::Heidenhain);
    for (const char* line : {"BEGIN PGM part MM", "TOOL CALL 3 Z S12000", "M128", "M129", "M30", "END PGM part MM"})
      EXPECT_TRUE(parsed.has(line)) << line;
    for (std::size_t i = 0; i < parsed.moves.size(); ++i)
      ASSERT_LT((*parsed.moves[i].normal - program.blocks[i].normal).norm(), 1e-7);
  }
}

TEST(ProgramDialects, WithoutRtcpTheMachinesAxesAreWritten)
{
  const ScratchFolder folder;
  const ToolPoses poses = testPath();
  const std::string file = folder.path("part.nc");
  for (Machine machine : testMachines()) {
    machine.rtcp = false;
    const MachineProgram program = programFor(machine, poses);
    for (Dialect dialect : {Dialect::LinuxCNC, Dialect::Fanuc}) {
      writeProgram(file, program, dialect, {"part", 0.0, 0, 5});
      const ParsedProgram parsed = parseFanuc(file);
      expectPath(machine, parsed, program, poses, dialect);
      EXPECT_FALSE(parsed.has("M5"));
    }
    for (Dialect dialect : {Dialect::FanucVectors, Dialect::Siemens, Dialect::Heidenhain}) {
      const ScratchFolder other;
      try {
        writeProgram(other.path("b.nc"), program, dialect, {});
        ADD_FAILURE() << "written without RTCP";
      }
      catch (const FileError& error) {
        EXPECT_NE(std::string(error.what()).find("rtcp: false"), std::string::npos) << error.what();
      }
      EXPECT_EQ(other.count(), 0U);
    }
  }
}

TEST(ProgramDialects, TheSpindleGoesUpFirstAndLastWhereTheMachineSaysHowFar)
{
  const ScratchFolder folder;
  Machine machine = testMachines()[0];
  machine.retract_z = 400.0;
  const MachineProgram program = programFor(machine, testPath());
  const auto count = [&](Dialect dialect, const std::string& line) {
    const std::string file = folder.path("part.nc");
    writeProgram(file, program, dialect, {"part", 0.0, 0, 4});
    const std::string text = readText(file);
    std::size_t found = 0;
    for (std::size_t at = text.find(line); at != std::string::npos; at = text.find(line, at + 1))
      ++found;
    return found;
  };
  EXPECT_EQ(count(Dialect::LinuxCNC, "\nG53 G0 Z400.0000\n"), 2U);
  EXPECT_EQ(count(Dialect::Fanuc, "\nG0 G53 Z400.0000\n"), 2U);
  EXPECT_EQ(count(Dialect::Siemens, "\nSUPA G0 Z400.0000 D0\n"), 2U);
  EXPECT_EQ(count(Dialect::Heidenhain, " L Z+400.000 R0 FMAX M91\n"), 2U);
}

TEST(ProgramDialects, TheToolLengthOfASiemensIsOffAtTheEndWithAndWithoutARetract)
{
  const ScratchFolder folder;
  const std::string file = folder.path("part.mpf");
  Machine machine = testMachines()[0];
  for (const std::optional<double> height : {std::optional<double>(), std::optional(400.0)}) {
    machine.retract_z = height;
    writeProgram(file, programFor(machine, testPath()), Dialect::Siemens, {"part", 0.0, 0, 4});
    const std::string text = readText(file);
    const std::size_t on = text.rfind(" D1\n"), off = text.rfind("D0\n"), end = text.rfind("M30\n");
    ASSERT_NE(on, std::string::npos);
    ASSERT_NE(off, std::string::npos);
    EXPECT_LT(on, off);
    EXPECT_LT(off, end);
    EXPECT_LT(text.rfind("\nTRAFOOF\n"), off) << "the tip needs the length";
    EXPECT_FALSE(std::regex_search(text.substr(off), std::regex("[XYZ][-0-9]"))) << "no move is made without the length";
  }
}

TEST(ProgramDialects, NumbersDoNotDependOnTheLocale)
{
  const ScratchFolder folder;
  const ToolPoses poses = testPath();
  const MachineProgram program = programFor(testMachines()[0], poses);
  const auto all = [&] {
    std::string text;
    for (Dialect dialect : {Dialect::LinuxCNC, Dialect::Fanuc, Dialect::FanucVectors, Dialect::Siemens, Dialect::Heidenhain}) {
      writeProgram(folder.path("a.nc"), program, dialect, {"part", 12500.0, 12, 4});
      text += readText(folder.path("a.nc"));
    }
    writeAPT(folder.path("a.apt"), ledPasses({poses}, {}), {"part", ballCutter(ball), 12500.0});
    return text + readText(folder.path("a.apt"));
  };
  const std::string plain = all();
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new CommaPoint));
  const std::string comma = all();
  std::locale::global(before);
  EXPECT_TRUE(plain == comma);
}

TEST(ProgramDialects, CommentsCannotEndThemselves)
{
  const ScratchFolder folder;
  const MachineProgram program = programFor(testMachines()[0], testPath());
  writeProgram(folder.path("a.ngc"), program, Dialect::LinuxCNC, {"a) M30 (b\nM2", 0.0, 0, 4});
  EXPECT_EQ(readText(folder.path("a.ngc")).rfind("(a  M30  b M2)\n", 0), 0U);
}

TEST(ProgramDialects, WhatCannotBeWrittenIsNamed)
{
  const ScratchFolder folder;
  EXPECT_THROW(writeProgram(folder.path("a.ngc"), MachineProgram(), Dialect::LinuxCNC, {}), FileError);
  const MachineProgram program = programFor(testMachines()[0], testPath());
  EXPECT_THROW(writeProgram(folder.path("a.ngc"), program, Dialect::LinuxCNC, {"a", 0.0, 0, 2}), FileError);
  EXPECT_THROW(writeProgram(folder.path("none/a.ngc"), program, Dialect::LinuxCNC, {}), FileError);
  EXPECT_THROW(writeAPT(folder.path("a.apt"), {}, {}), FileError);
  EXPECT_EQ(folder.count(), 0U);
}

TEST(PathExchange, AptSaysTipAxisAndFeedOfEveryMove)
{
  const ScratchFolder folder;
  const ToolPoses all = testPath();
  const std::vector<ToolPoses> passes{{all.begin() + 100, all.begin() + 400}, {all.begin() + 500, all.begin() + 900}};
  ProgramSettings settings;
  settings.feed = 1500.0;
  const std::vector<ToolMoves> led = ledPasses(passes, settings);
  writeAPT(folder.path("a.apt"), led, {"dome", ballCutter(ball), 12000.0, SpindleDirection::CounterClockwise, Coolant::Flood, 3});
  std::vector<std::string> others;
  const std::vector<AptMove> moves = parseAPT(folder.path("a.apt"), others);
  const std::vector<std::string> expected{"PARTNO dome",  "UNITS/MM",
                                          "MULTAX/ON",    "CUTTER/12.000000,6.000000,0.000000,6.000000,0.000000,0.000000,24.000000",
                                          "LOADTL/3",     "SPINDL/12000.0,RPM,CCLW",
                                          "COOLNT/FLOOD", "COOLNT/OFF",
                                          "SPINDL/OFF",   "FINI"};
  EXPECT_EQ(others, expected);
  ASSERT_EQ(moves.size(), led[0].size() + led[1].size());
  std::size_t rapids = 0;
  for (std::size_t i = 0, k = 0; i < moves.size(); ++i) {
    const bool second = i >= led[0].size();
    const ToolMove& move = second ? led[1][i - led[0].size()] : led[0][i];
    ASSERT_LT((moves[i].tip - move.pose.tip).norm(), 2e-6);
    ASSERT_LT(angleBetween(moves[i].axis.normalized(), move.pose.axis), 1e-8);
    ASSERT_NEAR(moves[i].axis.norm(), 1.0, 1e-8);
    ASSERT_EQ(moves[i].rapid, move.rapid);
    rapids += moves[i].rapid;
    if (move.section != BlockSection::Cut) {
      k = 0;
      ASSERT_TRUE(move.rapid || std::abs(moves[i].feed / 1500.0 - 1.0) < 0.011) << i;
      continue;
    }
    const ToolPoses& pass = passes[second ? 1 : 0];
    ++k;
    ASSERT_LT((moves[i].tip - pass[k].tip).norm(), 2e-6);
    const double contact = (pass[k].contact - pass[k - 1].contact).norm(), tip = (pass[k].tip - pass[k - 1].tip).norm();
    ASSERT_NEAR(moves[i].feed * contact / tip / 1500.0, 1.0, 0.011) << i;
  }
  EXPECT_EQ(rapids, 6U); // so near the pole the tool is at the top at once
  const ProgramFile read = readProgram(folder.path("a.apt"), {});
  ASSERT_EQ(read.program.blocks.size(), moves.size());
  for (std::size_t i = 0; i < moves.size(); ++i)
    ASSERT_EQ(read.program.blocks[i].rapid, moves[i].rapid);
}

TEST(PathExchange, AptOfAProgramHasItsMoves)
{
  const ScratchFolder folder;
  const MachineProgram program = programFor(testMachines()[2], testPath());
  writeAPT(folder.path("a.apt"), {movesOf(program)}, {"dome", ballCutter(ball)});
  std::vector<std::string> others;
  const std::vector<AptMove> moves = parseAPT(folder.path("a.apt"), others);
  ASSERT_EQ(moves.size(), program.blocks.size());
  for (std::size_t i = 0; i < moves.size(); ++i) {
    ASSERT_LT((moves[i].tip - program.blocks[i].tip).norm(), 2e-6);
    ASSERT_LT(angleBetween(moves[i].axis.normalized(), program.blocks[i].axis), 1e-8);
    ASSERT_EQ(moves[i].rapid, program.blocks[i].rapid);
    const double way = i > 0 ? (moves[i].tip - moves[i - 1].tip).norm() : 0.0;
    if (!moves[i].rapid && way > 1e-3)
      ASSERT_NEAR(way / moves[i].feed / program.blocks[i].minutes, 1.0, 0.012) << i;
  }
}

} // namespace program_dialects_test
