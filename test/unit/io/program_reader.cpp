// SPDX-License-Identifier: BSD-3-Clause
// Programs of every language read back for every kind of machine, and what cannot be understood.
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/path_exchange.h>
#include <pcl_spiral/io/program_reader.h>
#include <pcl_spiral/machine/impl/kinematics.h>
#include <pcl_spiral/machine/machine_program_generator.h>

#include "support/dome_spiral.h"
#include "support/scratch_folder.h"
#include "support/shortest_block.h"
#include "support/test_machines.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace program_reader_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

constexpr double ball = 6.0;

/** Two passes on a dome; by a link from one to the other if it is not longer than \p stay_down. */
MachineProgram
programFor(const Machine& machine, double stay_down = 0.0)
{
  ToolPoses far = domeSpiral(200.0, 2.0, 8, 60, ball, 13.0);
  far.erase(far.begin(), far.begin() + 200);
  MachineProgramGenerator generator;
  generator.setMachine(machine);
  generator.setInputPasses({domeSpiral(200.0, 2.0, 5, 60, ball, 13.0), far});
  ProgramSettings settings;
  settings.ball_radius = ball;
  settings.lead = LeadKind::Arc;
  settings.stay_down = stay_down;
  generator.setSettings(settings);
  MachineProgram program;
  generator.compute(program);
  EXPECT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
  return program;
}

/** The moves of \p read end as those of \p program, written in \p dialect; the first place may be named twice. */
void
expectMoves(const ProgramFile& read, const MachineProgram& program, Dialect dialect, const std::string& what)
{
  const std::vector<ProgramBlock>&found = read.program.blocks, &made = program.blocks;
  ASSERT_GE(found.size(), made.size()) << what;
  ASSERT_LE(found.size(), made.size() + 1) << what;
  ASSERT_EQ(read.lines.size(), found.size());
  const std::size_t shift = found.size() - made.size();
  for (std::size_t i = 0; i < made.size(); ++i) {
    const ProgramBlock &a = found[i + shift], &b = made[i];
    ASSERT_LT((a.tip - b.tip).norm(), 1e-3) << what << ", line " << read.lines[i + shift];
    ASSERT_LT((a.axis - b.axis).norm(), 2e-5) << what << ", line " << read.lines[i + shift];
    ASSERT_EQ(a.rapid, b.rapid) << what;
    ASSERT_EQ(a.section == BlockSection::Link, b.section == BlockSection::Link) << what;
    ASSERT_EQ(a.section == BlockSection::Cut, !b.rapid && b.section != BlockSection::Link) << what;
    if (!b.rapid)
      ASSERT_NEAR(a.minutes / std::max(b.minutes, shortestBlock(dialect)), 1.0, 0.01) << what << ", line " << read.lines[i + shift];
    ASSERT_TRUE(i == 0 || read.lines[i + shift] > read.lines[i + shift - 1]) << what;
  }
}

/** The message of reading \p text; empty if it is read. */
std::string
refusal(const std::string& text, const Machine& machine = testMachines()[0], const std::string& name = "part.ngc")
{
  const ScratchFolder folder;
  writeText(folder.path(name), text);
  try {
    readProgram(folder.path(name), machine);
    return "";
  }
  catch (const FileError& error) {
    return error.what();
  }
}

ProgramFile
programOf(const std::string& text, const Machine& machine, const std::string& name)
{
  const ScratchFolder folder;
  writeText(folder.path(name), text);
  return readProgram(folder.path(name), machine);
}

/** A program of one feed move, with \p line before it. */
std::string
around(const std::string& line)
{
  return "G21 G90 G94\nG43\nG0 X0 Y0 Z50 A0 C0\n" + line + "\nG1 Z10 F500\nM2\n";
}

} // namespace

TEST(ProgramReader, EveryLanguageIsReadBackForEveryMachine)
{
  const ScratchFolder folder;
  for (Machine machine : testMachines())
    for (bool rtcp : {true, false}) {
      machine.rtcp = rtcp;
      const MachineProgram program = programFor(machine);
      for (const DialectEntry& entry : dialect_entries) {
        if (entry.needs_rtcp && !rtcp)
          continue;
        for (const std::string extension : {entry.extension, ".nc"}) {
          if (extension.empty() || (extension == ".nc" && entry.dialect == Dialect::LinuxCNC))
            continue;
          const std::string file = folder.path("part" + extension);
          writeProgram(file, program, entry.dialect, {"part (1).pcd", 12000.0, 3, 4, "M62 P0", "M63 P0"});
          const ProgramFile read = readProgram(file, machine);
          EXPECT_EQ(read.language, entry.word);
          EXPECT_EQ(read.axis_arcs, entry.dialect == Dialect::Siemens);
          EXPECT_EQ(read.by_vectors, entry.needs_rtcp);
          expectMoves(read, program, entry.dialect, machine.name + " " + entry.word);
        }
      }
    }
}

TEST(ProgramReader, LinksBetweenPassesAreKnownByTheirMarks)
{
  const ScratchFolder folder;
  for (const Machine& machine : testMachines()) {
    const MachineProgram program = programFor(machine, 60.0);
    ASSERT_EQ(program.report.links, 1U);
    for (const DialectEntry& entry : dialect_entries) {
      const std::string file = folder.path("part.nc");
      writeProgram(file, program, entry.dialect, {"part", 12000.0, 3, 4, "M62 P0", "M63 P0"});
      expectMoves(readProgram(file, machine, entry.dialect), program, entry.dialect, machine.name + " " + entry.word);
    }
    writeAPT(folder.path("a.apt"), {movesOf(program)}, {"part", ballCutter(ball), 0.0});
    const ProgramFile read = readProgram(folder.path("a.apt"), machine);
    ASSERT_EQ(read.program.blocks.size(), program.blocks.size());
    for (std::size_t i = 0; i < program.blocks.size(); ++i)
      ASSERT_EQ(read.program.blocks[i].section == BlockSection::Link, program.blocks[i].section == BlockSection::Link);
  }
}

TEST(ProgramReader, AptIsReadBackWithAndWithoutAMachine)
{
  const ScratchFolder folder;
  const ToolPoses poses = domeSpiral(200.0, 2.0, 5, 60, ball, 13.0);
  ToolMoves moves;
  for (const ToolPose& pose : poses)
    moves.push_back({BlockSection::Cut, false, pose, 0.0});
  writeAPT(folder.path("a.apt"), {moves}, {"dome", ballCutter(ball), 12000.0});
  for (const std::optional<Machine>& machine : {std::optional<Machine>(), std::optional(testMachines()[2])}) {
    const ProgramFile read = readProgram(folder.path("a.apt"), machine);
    EXPECT_EQ(read.language, "apt");
    EXPECT_EQ(read.axis_arcs, !machine);
    ASSERT_EQ(read.program.blocks.size(), poses.size());
    for (std::size_t i = 0; i < poses.size(); ++i) {
      ASSERT_LT((read.program.blocks[i].tip - poses[i].tip).norm(), 2e-6);
      ASSERT_LT((read.program.blocks[i].axis - poses[i].axis).norm(), 1e-8);
    }
  }
}

TEST(ProgramReader, TheLastRetractEndsAtTheHeightOfTheMachineFile)
{
  const ScratchFolder folder;
  for (Machine machine : testMachines()) {
    machine.retract_z = 900.0;
    const MachineProgram program = programFor(machine);
    for (Dialect dialect : {Dialect::Fanuc, Dialect::Siemens, Dialect::Heidenhain}) {
      writeProgram(folder.path("part.nc"), program, dialect, {"part", 0.0, 3, 4});
      const ProgramFile read = readProgram(folder.path("part.nc"), machine);
      const ProgramBlock &last = read.program.blocks.back(), &before = *(read.program.blocks.end() - 2);
      const Kinematics kinematics(machine);
      EXPECT_NEAR(kinematics.gaugePoint(last.machine).z(), 900.0, 1e-6) << machine.name << " " << entryOf(dialect).word;
      const Eigen::Vector3d way = kinematics.gaugePoint(last.machine) - kinematics.gaugePoint(before.machine);
      EXPECT_LT(way.head<2>().norm(), 1e-6);
      EXPECT_TRUE(last.rapid);
    }
  }
}

TEST(ProgramReader, ModalWordsAndCommentsAreFollowed)
{
  const ProgramFile read = programOf("%\n(a comment G1 X5)\nG21G90G94 ; another\nG43H1\nN10 G0X0Y0Z50A0C0\nG1Z10F500\nX10\n"
                                     "N30 Y -1.5 (here) A90\nG20\nx1.\nG21 G93 X26.4 F4\nG94 X27.4 F60\nG4 P2\nM2\nG1 X1000\n",
                                     testMachines()[0], "part.ngc");
  const std::vector<Eigen::Vector3d> tips{{0, 0, 50},       {0, 0, 10},       {10, 0, 10},     {10, -1.5, 10},
                                          {25.4, -1.5, 10}, {26.4, -1.5, 10}, {27.4, -1.5, 10}};
  const std::vector<std::size_t> lines{5, 6, 7, 8, 10, 11, 12};
  ASSERT_EQ(read.program.blocks.size(), tips.size());
  for (std::size_t i = 0; i < tips.size(); ++i)
    EXPECT_LT((read.program.blocks[i].tip - tips[i]).norm(), 1e-12) << i;
  EXPECT_EQ(read.lines, lines);
  EXPECT_NEAR(read.program.blocks[3].angles.second, 90.0 * degree, 1e-12);
  EXPECT_NEAR(read.program.blocks[2].minutes, 10.0 / 500.0, 1e-12);
  EXPECT_NEAR(read.program.blocks[5].minutes, 0.25, 1e-12);
  EXPECT_NEAR(read.program.blocks[6].minutes, 1.0 / 60.0, 1e-12);
}

/** The minutes of the last move of \p text. */
double
lastMinutes(const std::string& text, const Machine& machine, const std::string& name)
{
  return programOf(text, machine, name).program.blocks.back().minutes;
}

TEST(ProgramReader, FeedsOfRotaryAxesAreThoseOfTheManuals)
{
  Machine tips = testMachines()[0], axes = tips; // C and A
  axes.rtcp = false;
  const std::string start = "G43 H1\nG0 X0 Y0 Z50 A0 C0\nG1 ", end = "\nM2\n", inch = "G20 G90 G94\n", mm = "G21 G90 G94\n";
  const double turn = std::hypot(30.0, 40.0);
  for (const Machine& machine : {tips, axes}) {
    EXPECT_NEAR(lastMinutes(mm + start + "A30 C40 F300" + end, machine, "a.ngc"), turn / 300.0, 1e-9) << "no X Y Z: degrees/min";
    EXPECT_NEAR(lastMinutes(inch + start + "A30 C40 F300" + end, machine, "a.ngc"), turn / 300.0, 1e-9) << "of inches, too";
    EXPECT_NEAR(lastMinutes(mm + start + "X20 C40 F300" + end, machine, "a.ngc"), 20.0 / 300.0, 1e-9) << "X Y Z alone count";
    EXPECT_NEAR(lastMinutes(inch + start + "X20 C40 F300" + end, machine, "a.ngc"), 20.0 / 300.0, 1e-9);
  }
  const std::string fanuc = "%\nO0001\n", last = "\nM30\n%\n", with_tips = "G43.4 H1\nG0 X0 Y0 Z50 A0 C0\nG1 ";
  EXPECT_NEAR(lastMinutes(fanuc + mm + start + "X20 C40 F300" + last, axes, "a.nc"), 0.14907, 1e-5) << "the example of B-63174EN, 4.2";
  EXPECT_NEAR(lastMinutes(fanuc + mm + start + "C40 F300" + last, axes, "a.nc"), 40.0 / 300.0, 1e-9);
  EXPECT_NEAR(lastMinutes(fanuc + mm + with_tips + "X20 C40 F300" + last, tips, "a.nc"), 20.0 / 300.0, 1e-9) << "of the tip";
  const auto klartext = [](const std::string& unit, const std::string& move) {
    return "0 BEGIN PGM A " + unit + "\n1 TOOL CALL 3 Z S1000\n2 M128\n3 L X+0 Y+0 Z+50 A+0 C+0 FMAX M3\n4 L " + move +
           "\n5 M30\n6 END PGM A " + unit + "\n";
  };
  for (const char* unit : {"MM", "INCH"})
    EXPECT_NEAR(lastMinutes(klartext(unit, "A+30 C+40 F300"), tips, "a.h"), turn / 300.0, 1e-9) << unit;
  EXPECT_NEAR(lastMinutes(klartext("MM", "X+20 C+40 F300"), tips, "a.h"), 20.0 / 300.0, 1e-9);
  EXPECT_NEAR(lastMinutes(klartext("INCH", "X+20 C+40 F300"), tips, "a.h"), 20.0 / 30.0, 1e-9) << "F in tenths of an inch";
}

TEST(ProgramReader, WhatIsNotUnderstoodIsRefusedWithLineAndWord)
{
  EXPECT_EQ(refusal(around("G1 X1 F100")), "");
  const std::vector<std::pair<std::string, std::string>> lines{
      {"G2 X1 Y1 I1", "line 4: G2: an arc"},
      {"G81 Z1 R2", "line 4: G81: a cycle"},
      {"M98 P100", "line 4: M98: a subprogram"},
      {"O100 call", "line 4: "},
      {"G91", "line 4: G91: relative coordinates"},
      {"G54\nG55", "line 5: G55: another work offset than G54"},
      {"G41 D1", "line 4: G41: "},
      {"G68 R10", "line 4: G68: it turns"},
      {"#1=5", "line 4: '#1=5' is not understood"},
      {"G1 X[1+2]", "line 4: '[1+2]' is not understood"},
      {"/G1 X1", "line 4: '/G1 X1' is not"},
      {"G1 B10 F100", "line 4: B10: the rotary axes of the machine file are C and A"},
      {"G1 U5 F100", "line 4: U5: not a word"},
      {"G1 I1 J0 K0 F100", "line 4: I1: the centre of an arc"},
      {"G93\nG1 X1", "line 5: with G93"},
      {"G1 X1 X2 F100", "line 4: X2: the axis is named twice"},
      {"G49\nG1 X1 F100", "line 5: the tool length is not on"},
      {"TRAORI", "line 4: TRAORI: not a word"},
      {"M430", "line 4: M430: it changes the kinematics"},
      {"G1 X1.2.3 F1", "line 4: 'X1.2.3' has no number"},
      {"T4 M6", "line 4: M6: another tool"},
      {"G1 X1 (F100", "line 4: a comment begins"}};
  for (const auto& [line, message] : lines)
    EXPECT_NE(refusal(around(line)).find(message), std::string::npos) << line << ": " << refusal(around(line));
  EXPECT_NE(refusal("G43\nG1 X1 Y0 Z0 A0 C0 F100\nM2\n").find("line 2: the place from which this feed move starts"), std::string::npos);
  EXPECT_NE(refusal("G43\nG0 X1 Y0 Z0 A0 C0\n").find("ends without M2"), std::string::npos);
  EXPECT_NE(refusal("G43\nX1 Y0 Z0 A0 C0\nM2\n").find("line 2: axes are named, but neither G0 nor G1"), std::string::npos);
  EXPECT_NE(refusal("0 BEGIN PGM a MM\n1 M128\n2 LN X0 Y0 Z9 TX0 TY0 TZ1 FMAX\n4 LN X0 Y0 Z5 TX0 TY0 TZ1 F99\n5 END PGM a MM\n",
                    testMachines()[0], "a.nc")
                .find("line 4: the line has the number 4, and 3 follows: a block is missing"),
            std::string::npos);
  EXPECT_NE(
      refusal("UNITS/MM\nGOTO/0,0,0,0,0,1\nCYCLE/DRILL\nFINI\n", testMachines()[0], "a.apt").find("line 3: 'CYCLE' is not understood"),
      std::string::npos);
  EXPECT_NE(refusal("UNITS/MM\nGOTO/0,0,0,0,0,1\nGOTO/1,0,0\n", testMachines()[0], "a.apt").find("ends without FINI"), std::string::npos);
}

TEST(ProgramReader, FeedMovesWithTheSpindleOffAreFound)
{
  const ScratchFolder folder;
  const Machine machine = testMachines()[0];
  const MachineProgram program = programFor(machine);
  for (const DialectEntry& entry : dialect_entries)
    for (const double speed : {0.0, 12000.0}) {
      const std::string file = folder.path(std::string("part") + (entry.dialect == Dialect::LinuxCNC ? ".ngc" : ".nc"));
      writeProgram(file, program, entry.dialect, {"part", speed, 3, 4});
      const ProgramFile read = readProgram(file, machine);
      std::size_t first = 0; // the first feed move
      for (std::size_t i = read.program.blocks.size(); i-- > 0;)
        first = read.program.blocks[i].rapid ? first : read.lines[i];
      EXPECT_EQ(read.still_line, speed > 0.0 ? 0 : first) << entry.word;
    }
}

TEST(ProgramReader, AMachineThatTheProgramWasNotMadeForIsRefusedAndItsOwnIsNot)
{
  const ScratchFolder folder;
  const std::vector<Machine> machines = testMachines();
  for (const Machine& machine : {machines[0], machines[1], machines[2], machines[3]}) {
    const MachineProgram program = programFor(machine);
    for (const DialectEntry& entry : dialect_entries) {
      writeProgram(folder.path("part.nc"), program, entry.dialect, {"part", 0.0, 3, 4});
      for (const Machine& other : {machines[0], machines[1], machines[2], machines[3]}) {
        const std::string message = refusal(::readText(folder.path("part.nc")), other, "part.nc");
        EXPECT_EQ(message.empty(), other.name == machine.name) << machine.name << " " << entry.word << " " << other.name << message;
        if (!message.empty())
          EXPECT_NE(message.find("line "), std::string::npos) << message;
      }
      Machine without = machine;
      without.rtcp = false;
      std::string text = ::readText(folder.path("part.nc"));
      EXPECT_NE(refusal(text, without, "part.nc"), "");
      text.replace(text.find("from work to tool"), 4, "FROM"); // without the comment, the words of the language show it
      if (entry.dialect != Dialect::LinuxCNC) {
        EXPECT_NE(refusal(text, without, "part.nc").find("rtcp: false"), std::string::npos) << refusal(text, without, "part.nc");
        EXPECT_EQ(refusal(text, machine, "part.nc"), ""); // the remedy: rtcp: true
      }
    }
  }
}

} // namespace program_reader_test
