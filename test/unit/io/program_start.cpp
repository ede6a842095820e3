// SPDX-License-Identifier: BSD-3-Clause
// What stands around the moves of a program: the order of start and end, the shop's lines, offsets, coolant, smoothing, line numbers, and
// feeds in mm/min.
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/machine_reader.h>
#include <pcl_spiral/io/program_reader.h>
#include <pcl_spiral/io/program_writer.h>
#include <pcl_spiral/machine/machine_program_generator.h>

#include "support/dome_spiral.h"
#include "support/scratch_folder.h"
#include "support/test_machines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <regex>
#include <sstream>

namespace program_start_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

const std::vector<Dialect> dialects{Dialect::LinuxCNC, Dialect::Fanuc, Dialect::FanucVectors, Dialect::Siemens, Dialect::Heidenhain};

Machine
shopMachine()
{
  Machine machine = testMachines()[0];
  machine.retract_z = 400.0;
  machine.lines.header = {"(shop of {part})", "M98 P{tool}"};
  machine.lines.footer = {"M98 P9001 (up to {safe_z}, {feed} mm a minute)"};
  machine.lines.pass_begin = {"M62 P0"};
  machine.lines.pass_end = {"M63 P0"};
  machine.words.tip_control_on = "M428";
  machine.words.tip_control_off = "M429";
  return machine;
}

MachineProgram
programFor(const Machine& machine, double axis_tilt = 13.0)
{
  MachineProgramGenerator generator;
  generator.setMachine(machine);
  ToolPoses poses = domeSpiral(200.0, 2.0, 6, 40, 6.0, axis_tilt);
  if (machine.three_axes)
    for (ToolPose& pose : poses) {
      pose.axis = Eigen::Vector3d::UnitZ();
      pose.tip = pose.contact + 6.0 * (pose.normal - pose.axis);
    }
  generator.setInputPoses(poses);
  ProgramSettings settings;
  settings.ball_radius = 6.0;
  generator.setSettings(settings);
  MachineProgram program;
  generator.compute(program);
  EXPECT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
  return program;
}

ProgramHeader
fullHeader()
{
  ProgramHeader header{"part.pcd", 12000.0, 3, 4};
  header.coolant = Coolant::Flood;
  header.smoothing = 0.005;
  header.notes = {"cutter radius 6 mm"};
  return header;
}

std::string
textOf(const MachineProgram& program, Dialect dialect, const ProgramHeader& header)
{
  const ScratchFolder folder;
  writeProgram(folder.path("part.nc"), program, dialect, header);
  return readText(folder.path("part.nc"));
}

/** \p patterns, as whole lines, stand in \p text in this order. */
void
expectOrder(const std::string& text, const std::vector<std::string>& patterns, const std::string& what)
{
  std::istringstream stream(text);
  std::size_t next = 0;
  for (std::string line; std::getline(stream, line) && next < patterns.size();)
    next += std::regex_match(line, std::regex(patterns[next]));
  EXPECT_EQ(next, patterns.size()) << what << ": no line '" << (next < patterns.size() ? patterns[next] : "") << "' in its place";
}

std::string
refusal(const MachineProgram& program, Dialect dialect, const ProgramHeader& header)
{
  try {
    textOf(program, dialect, header);
  }
  catch (const FileError& error) {
    return error.what();
  }
  return "";
}

const std::string number = "-?[0-9]+\\.[0-9]+";

} // namespace

TEST(ProgramStart, RetractToolSpindleCoolantOffsetAnglesPlaceAndOnlyThenTheTip)
{
  const MachineProgram program = programFor(shopMachine());
  const std::string a_c = "A" + number + " C" + number, x_y = "X" + number + " Y" + number;
  expectOrder(textOf(program, Dialect::LinuxCNC, fullHeader()),
              {"\\(part.pcd\\)",
               "\\(work offset G54\\)",
               "\\(cutter radius 6 mm\\)",
               "G21 G90 .*",
               "M429",
               "G49",
               "\\(shop of part.pcd\\)",
               "M98 P3",
               "G53 G0 Z400.0000",
               "T3 M6",
               "G43",
               "S12000 M3",
               "M8",
               "G54",
               "G64 P0.005000",
               "G0 " + a_c,
               "G0 " + x_y,
               "M428",
               "G93",
               "G0 X.* A.*",
               "G1 .*",
               "M62 P0",
               "G1 .*",
               "M63 P0",
               "G1 .*",
               "G0 .*",
               "G94",
               "M429",
               "G49",
               "G53 G0 Z400.0000",
               "M5",
               "M9",
               "M98 P9001 \\(up to 400, 1000 mm a minute\\)",
               "M2"},
              "linuxcnc");
  expectOrder(textOf(program, Dialect::Fanuc, fullHeader()),
              {"%",
               "O0001 \\(part.pcd\\)",
               "G21 G90 .*",
               "\\(shop of part.pcd\\)",
               "G0 G53 Z400.0000",
               "T3 M6",
               "S12000 M3",
               "M8",
               "G54",
               "G5.1 Q1",
               "G0 " + a_c,
               "G0 " + x_y,
               "G43.4 H3 X.* A.*",
               "G93",
               "G1 .*",
               "G94",
               "G49",
               "G0 G53 Z400.0000",
               "M5",
               "M9",
               "G5.1 Q0",
               "M98 P9001 .*",
               "M30",
               "%"},
              "fanuc");
  expectOrder(textOf(program, Dialect::Siemens, fullHeader()),
              {"; part.pcd",
               "G71 G90 .*",
               "M98 P3",
               "SUPA G0 Z400.0000 D0",
               "T3 M6",
               "S12000 M3",
               "M8",
               "G54 D1",
               "CYCLE832\\(0.005000,_ORI_FINISH,0.050000\\)",
               "G0 " + a_c,
               "G0 " + x_y,
               "TRAORI",
               "G54",
               "ORIWKS",
               "ORIVECT",
               "G93",
               "G1 .*",
               "G94",
               "TRAFOOF",
               "SUPA G0 Z400.0000 D0",
               "M5",
               "M9",
               "CYCLE832\\(0,_OFF,1\\)",
               "M98 P9001 .*",
               "M30"},
              "siemens");
  expectOrder(textOf(program, Dialect::Heidenhain, fullHeader()),
              {"0 BEGIN PGM part MM",
               "1 ; part.pcd",
               "[0-9]+ M98 P3",
               "[0-9]+ L Z\\+400.000 R0 FMAX M91",
               "[0-9]+ TOOL CALL 3 Z S12000",
               "[0-9]+ M3",
               "[0-9]+ M8",
               "[0-9]+ CYCL DEF 32.0 TOLERANCE",
               "[0-9]+ CYCL DEF 32.1 T0.005000",
               "[0-9]+ CYCL DEF 32.2 HSC-MODE:0 TA0.050000",
               "[0-9]+ L A[+-].* C[+-].* R0 FMAX",
               "[0-9]+ L X.* Y.* R0 FMAX",
               "[0-9]+ M128",
               "[0-9]+ LN .*",
               "[0-9]+ M129",
               "[0-9]+ L Z\\+400.000 R0 FMAX M91",
               "[0-9]+ M5",
               "[0-9]+ M9",
               "[0-9]+ M30",
               "[0-9]+ END PGM part MM"},
              "heidenhain");
}

/** Between tip control on and off no line moves the rotary axes alone, and none before it moves Z but the retract. */
TEST(ProgramStart, TheMovesAtTheRetractHeightAreBlocks)
{
  const MachineProgram program = programFor(shopMachine());
  const ProgramBlock &first = program.blocks.front(), &second = program.blocks[1], &last = program.blocks.back();
  const auto gauge = [&](const ProgramBlock& block) { // of a table-table machine whose tool length is that of the file
    return Eigen::Vector3d(block.machine + program.machine.work_zero + Eigen::Vector3d(0, 0, program.machine.tool_length));
  };
  EXPECT_EQ(first.section, BlockSection::Start);
  EXPECT_NEAR(gauge(first).z(), 400.0, 1e-9);
  EXPECT_LT((gauge(first) - gauge(second)).head<2>().norm(), 1e-9) << "over the first point";
  EXPECT_EQ(last.section, BlockSection::End);
  EXPECT_NEAR(gauge(last).z(), 400.0, 1e-9);
  EXPECT_TRUE(first.rapid && last.rapid);
}

TEST(ProgramStart, OffsetsAreThoseOfTheControl)
{
  const MachineProgram program = programFor(shopMachine());
  const auto with = [](const std::string& offset) {
    ProgramHeader header = fullHeader();
    header.work_offset = offset;
    return header;
  };
  EXPECT_NE(textOf(program, Dialect::LinuxCNC, with("G59.2")).find("\nG59.2\n"), std::string::npos);
  EXPECT_NE(textOf(program, Dialect::Fanuc, with("G54.1 P17")).find("\nG54.1 P17\n"), std::string::npos);
  EXPECT_NE(textOf(program, Dialect::Siemens, with("G505")).find("\nTRAORI\nG505\n"), std::string::npos);
  EXPECT_NE(textOf(program, Dialect::Heidenhain, with("2")).find(" CYCL DEF 247 DATUM SETTING Q339=+2\n"), std::string::npos);
  for (const auto& [dialect, offset] :
       {std::pair(Dialect::LinuxCNC, "G54.1 P1"), std::pair(Dialect::Fanuc, "G59.1"), std::pair(Dialect::Fanuc, "G54.1 P301"),
        std::pair(Dialect::Siemens, "G58"), std::pair(Dialect::Heidenhain, "G54")}) {
    const std::string message = refusal(program, dialect, with(offset));
    EXPECT_NE(message.find(std::string("the work offset '") + offset + "' is none of this control; give "), std::string::npos) << message;
  }
}

TEST(ProgramStart, AnOffsetOtherThanThatOfTheCommentIsFoundInTheText)
{
  const ScratchFolder folder;
  const Machine machine = shopMachine();
  std::string text = textOf(programFor(machine), Dialect::LinuxCNC, fullHeader());
  writeText(folder.path("part.ngc"), text);
  EXPECT_NO_THROW(readProgram(folder.path("part.ngc"), machine));
  text.replace(text.find("\nG54\n"), 5, "\nG55\n");
  writeText(folder.path("part.ngc"), text);
  try {
    readProgram(folder.path("part.ngc"), machine);
    ADD_FAILURE() << "read";
  }
  catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find("G55: the comment says that the program was made for the work offset G54"), std::string::npos)
        << error.what();
  }
}

TEST(ProgramStart, CoolantHasTheWordsOfTheMachine)
{
  MachineProgram program = programFor(shopMachine());
  ProgramHeader header = fullHeader();
  header.coolant = Coolant::Through;
  EXPECT_NE(refusal(program, Dialect::Fanuc, header).find("give it in the machine file, such as program: {coolant: {through: M88}}"),
            std::string::npos);
  program.machine.words.through = "M88";
  program.machine.words.coolant_off = "M89";
  const std::string text = textOf(program, Dialect::Fanuc, header);
  EXPECT_NE(text.find("\nM88\n"), std::string::npos);
  EXPECT_NE(text.find("\nM89\n"), std::string::npos);
  EXPECT_EQ(text.find("\nM9\n"), std::string::npos);
  header.spindle_direction = SpindleDirection::CounterClockwise;
  EXPECT_NE(textOf(program, Dialect::Fanuc, header).find("\nS12000 M4\n"), std::string::npos);
}

TEST(ProgramStart, SmoothingIsOfTheFileOrOfTheHeaderOrTheShops)
{
  MachineProgram program = programFor(shopMachine());
  program.machine.path_tolerance = 0.02;
  EXPECT_NE(textOf(program, Dialect::LinuxCNC, fullHeader()).find("\nG64 P0.020000\n"), std::string::npos);
  program.machine.path_tolerance = 0.0;
  EXPECT_NE(textOf(program, Dialect::LinuxCNC, fullHeader()).find("\nG61\n"), std::string::npos);
  program.machine.path_tolerance.reset();
  program.machine.words.smoothing_on = {"G8 P1 (within {tolerance})"};
  program.machine.words.smoothing_off = {"G8 P0"};
  const std::string text = textOf(program, Dialect::Fanuc, fullHeader());
  EXPECT_NE(text.find("\nG8 P1 (within 0.005)\n"), std::string::npos);
  EXPECT_NE(text.find("\nG8 P0\n"), std::string::npos);
  EXPECT_EQ(text.find("G5.1"), std::string::npos);
  program.machine.retract_z.reset();
  EXPECT_NE(refusal(program, Dialect::Fanuc, fullHeader()).find("{safe_z}, and the machine file has no retract_z"), std::string::npos);
}

TEST(ProgramStart, LineNumbersCountOnAndBeginAgainBeforeSixDigits)
{
  const MachineProgram program = programFor(shopMachine());
  ProgramHeader header = fullHeader();
  header.line_step = 1000;
  for (const Dialect dialect : {Dialect::LinuxCNC, Dialect::Fanuc, Dialect::Siemens}) {
    const std::string numbered = textOf(program, dialect, header);
    std::istringstream stream(numbered);
    std::string plain;
    std::size_t expected = 1000, highest = 0;
    for (std::string line; std::getline(stream, line);) {
      std::smatch match;
      if (std::regex_match(line, match, std::regex("N([0-9]+) (.*)"))) {
        ASSERT_EQ(std::stoul(match[1]), expected) << line;
        highest = std::max(highest, expected);
        expected = expected + 1000 > 99999 ? 1000 : expected + 1000;
        line = match[2];
      }
      plain += line + "\n";
    }
    EXPECT_EQ(highest, 99000U);
    header.line_step = 0;
    EXPECT_TRUE(plain == textOf(program, dialect, header));
    header.line_step = 1000;
  }
}

TEST(ProgramStart, EveryLanguageIsReadBackWithTheShopsLines)
{
  const ScratchFolder folder;
  const Machine machine = shopMachine();
  const MachineProgram program = programFor(machine);
  for (const Dialect dialect : dialects)
    for (const int step : {0, 10}) {
      ProgramHeader header = fullHeader();
      header.line_step = step;
      const std::string file = folder.path(dialect == Dialect::LinuxCNC ? "part.ngc" : "part.nc");
      writeProgram(file, program, dialect, header);
      const ProgramFile read = readProgram(file, machine);
      ASSERT_GE(read.program.blocks.size(), program.blocks.size()) << entryOf(dialect).word;
      EXPECT_LT((read.program.blocks.front().tip - program.blocks.front().tip).norm(), 1e-3) << entryOf(dialect).word;
      EXPECT_LT((read.program.blocks.back().tip - program.blocks.back().tip).norm(), 1e-3) << entryOf(dialect).word;
    }
}

/** F is the way of the tip over the time of the block. */
TEST(ProgramStart, FeedsInMillimetresAMinuteAreTheTips)
{
  const MachineProgram program = programFor(shopMachine());
  ProgramHeader header = fullHeader();
  header.feed_mode = FeedMode::PerMinute;
  for (const Dialect dialect : {Dialect::Fanuc, Dialect::Siemens}) {
    std::istringstream stream(textOf(program, dialect, header));
    std::size_t checked = 0, block = 1;
    for (std::string line; std::getline(stream, line);) {
      EXPECT_EQ(line.find("G93"), std::string::npos);
      std::smatch f;
      if (!std::regex_match(line, f, std::regex("G[01] X.* Z[^ ]+ .*?(?:F([0-9.]+))?")))
        continue;
      if (f[1].matched) {
        const ProgramBlock &before = program.blocks[block - 1], &at = program.blocks[block];
        const double way = (at.tip - before.tip).norm();
        if (way > 0.01)
          ASSERT_NEAR(std::stod(f[1]) * at.minutes / way, 1.0, 1e-3 + 2e-4 / way) << line; // the text has four decimals
        checked += way > 0.01;
      }
      ++block;
    }
    EXPECT_GT(checked, 100U);
  }
  for (const Dialect dialect : {Dialect::LinuxCNC, Dialect::Heidenhain})
    EXPECT_NE(refusal(program, dialect, header).find("needs fanuc, fanuc-ijk or siemens"), std::string::npos);
}

TEST(ProgramStart, AThreeAxisProgramHasNoRotaryWords)
{
  Machine machine;
  machine.name = "mill";
  machine.three_axes = true;
  machine.retract_z = 150.0;
  machine.work_zero = {0.0, 0.0, -300.0};
  machine.tool_length = 80.0;
  const MachineProgram program = programFor(machine);
  const ScratchFolder folder;
  for (const Dialect dialect : {Dialect::LinuxCNC, Dialect::Fanuc, Dialect::Siemens, Dialect::Heidenhain}) {
    const std::string text = textOf(program, dialect, fullHeader());
    EXPECT_FALSE(std::regex_search(text, std::regex("\n[^(;\n]* [ABC]3?=?[+-]?[0-9]"))) << entryOf(dialect).word;
    for (const char* word : {"G93", "G43.4", "M428", "TRAORI", "M128", "LN "})
      EXPECT_EQ(text.find(word), std::string::npos) << entryOf(dialect).word << word;
    const std::string file = folder.path(dialect == Dialect::LinuxCNC ? "part.ngc" : "part.nc");
    writeText(file, text);
    const ProgramFile read = readProgram(file, machine, dialect);
    const std::vector<ProgramBlock>& blocks = read.program.blocks;
    ASSERT_GE(blocks.size(), program.blocks.size()) << entryOf(dialect).word;
    const std::size_t shift = blocks.size() - program.blocks.size();
    double minutes = 0.0;
    for (std::size_t i = 2; i < program.blocks.size(); ++i) {
      ASSERT_LT((blocks[i + shift].tip - program.blocks[i].tip).norm(), 1e-3) << entryOf(dialect).word << i;
      minutes += blocks[i + shift].minutes;
    }
    EXPECT_NEAR(minutes / program.report.minutes, 1.0, 1e-3);
  }
  EXPECT_NE(refusal(program, Dialect::FanucVectors, fullHeader()).find("use fanuc"), std::string::npos);
}

TEST(ProgramStart, AThreeAxisMachineRefusesALeaningTool)
{
  Machine machine;
  machine.three_axes = true;
  MachineProgramGenerator generator;
  generator.setMachine(machine);
  generator.setInputPoses(domeSpiral(200.0, 2.0, 6, 40, 6.0, 13.0));
  MachineProgram program;
  generator.compute(program);
  EXPECT_NE(
      generator.getStatus().message().find("a machine with three axes cannot tilt the tool; make the path with the tool axis along +Z"),
      std::string::npos)
      << generator.getStatus().message();
}

TEST(ProgramStart, LinuxCNCsToolLengthGoesOffOnlyInTheIdentity)
{
  Machine machine = shopMachine();
  EXPECT_NE(textOf(programFor(machine), Dialect::LinuxCNC, fullHeader()).find("\nM429\nG49\n"), std::string::npos);
  machine.words.tip_control_on.clear();
  machine.words.tip_control_off.clear(); // the kinematics of the tip never end, and use the length
  EXPECT_EQ(textOf(programFor(machine), Dialect::LinuxCNC, fullHeader()).find("G49"), std::string::npos);
  machine.rtcp = false;
  EXPECT_NE(textOf(programFor(machine), Dialect::LinuxCNC, fullHeader()).find("\nG94\nG49\n"), std::string::npos);
}

TEST(ProgramStart, FanucGetsNoInverseTimeAboveItsRange)
{
  MachineProgram program = programFor(shopMachine());
  std::find_if(program.blocks.begin(), program.blocks.end(), [](const ProgramBlock& block) {
    return block.section == BlockSection::Cut;
  })->minutes = 1e-5;
  const auto highest = [&program](Dialect dialect) {
    const std::string text = textOf(program, dialect, fullHeader());
    double most = 0.0;
    for (std::size_t at = text.find(" F"); at != std::string::npos; at = text.find(" F", at + 1))
      most = std::max(most, std::atof(text.c_str() + at + 2));
    return most;
  };
  EXPECT_EQ(highest(Dialect::Fanuc), 9999.999);
  EXPECT_EQ(highest(Dialect::FanucVectors), 9999.999);
  EXPECT_EQ(highest(Dialect::LinuxCNC), 100000.0);
}

} // namespace program_start_test
