// SPDX-License-Identifier: BSD-3-Clause
// Codes before and after each row of a program, read back in every language: a beam is on only along the rows.
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/machine/machine_program_generator.h>

#include "support/beam_way.h"
#include "support/canonical_run.h"
#include "support/dome_spiral.h"
#include "support/scratch_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>

namespace pass_codes_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

const Dialect dialects[] = {Dialect::LinuxCNC, Dialect::Fanuc, Dialect::FanucVectors, Dialect::Siemens, Dialect::Heidenhain};

/** Three rows away from the pole, of three turns, half a turn and two. */
std::vector<ToolPoses>
threeRows()
{
  const ToolPoses all = domeSpiral(200.0, 4.0, 16, 60, 6.0, 13.0);
  const auto row = [&all](int first, int last) { return ToolPoses(all.begin() + first, all.begin() + last); };
  return {row(300, 481), row(540, 571), row(660, 781)};
}

MachineProgram
programFor(const Machine& machine, const std::vector<ToolPoses>& rows)
{
  MachineProgramGenerator generator;
  generator.setMachine(machine);
  generator.setInputPasses(rows);
  MachineProgram program;
  generator.compute(program);
  EXPECT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
  return program;
}

ProgramHeader
withCodes(int decimals = 4)
{
  ProgramHeader header{"rows", 0.0, 0, decimals};
  header.pass_begin = on_code;
  header.pass_end = off_code;
  return header;
}

bool
takes(const Machine& machine, Dialect dialect)
{
  return machine.rtcp || dialect == Dialect::LinuxCNC || dialect == Dialect::Fanuc;
}

/** The interpreter's motions as a program, its outputs as lines. */
ParsedProgram
asProgram(const CanonicalRun& run)
{
  ParsedProgram program;
  std::size_t at = 0;
  const auto addOutputs = [&] {
    for (; at < run.outputs.size() && run.outputs[at].motions_before == program.moves.size(); ++at)
      program.addOther(run.outputs[at].on ? on_code : off_code);
  };
  for (const CanonicalMotion& motion : run.motions) {
    addOutputs();
    const auto& v = motion.xyzabc;
    program.moves.push_back({motion.rapid, {v[0], v[1], v[2]}, {{'A', v[3]}, {'B', v[4]}, {'C', v[5]}}, {}, {}, 0.0});
  }
  addOutputs();
  return program;
}

Machine
withLimits(Machine machine)
{
  machine.rotary[0].range.lower = -400.0 * M_PI / 180.0;
  machine.rotary[0].range.upper = 350.0 * M_PI / 180.0;
  return machine;
}

} // namespace

TEST(PassCodes, OnceARowInEveryLanguage)
{
  const ScratchFolder folder;
  const std::string file = folder.path("rows.nc");
  const std::vector<ToolPoses> rows = threeRows();
  for (Machine machine : testMachines())
    for (const bool rtcp : {true, false}) {
      machine.rtcp = rtcp;
      const MachineProgram program = programFor(machine, rows);
      for (const Dialect dialect : dialects) {
        if (!takes(machine, dialect))
          continue;
        writeProgram(file, program, dialect, withCodes());
        const ParsedProgram read = parsed(file, dialect);
        EXPECT_EQ(read.placesOf(on_code).size(), rows.size());
        EXPECT_EQ(expectBeamsOnRows(machine, read, rows), 0U);
      }
    }
}

TEST(PassCodes, OffWhileAnAxisUnwindsWithinARow)
{
  const ScratchFolder folder;
  const std::string file = folder.path("rows.nc");
  const std::vector<ToolPoses> rows = threeRows();
  for (Machine machine : testMachines()) {
    machine = withLimits(machine);
    const MachineProgram program = programFor(machine, rows);
    std::size_t broken = 0;
    for (const Dialect dialect : dialects) {
      if (dialect == Dialect::FanucVectors) { // a vector is the same after a whole turn
        EXPECT_THROW(writeProgram(file, program, dialect, withCodes()), FileError);
        continue;
      }
      writeProgram(file, program, dialect, withCodes());
      const ParsedProgram read = parsed(file, dialect);
      const std::size_t times = expectBeamsOnRows(machine, read, rows);
      if (dialect == Dialect::LinuxCNC)
        broken = times;
      EXPECT_EQ(times, broken);
      if (read.moves[0].vector)
        continue;
      const auto first = [&](std::size_t i) { return read.moves[i].degrees.at(machine.rotary[0].letter); };
      const std::vector<Beam> beams = beamsOf(read);
      double on = 0.0, largest_off = 0.0;
      for (std::size_t k = 0; k < beams.size(); ++k) {
        for (std::size_t i = beams[k].on; i < beams[k].off; ++i)
          on += std::abs(first(i) - first(i - 1));
        if (k > 0)
          largest_off = std::max(largest_off, std::abs(first(beams[k].on - 1) - first(beams[k - 1].off - 1)));
      }
      EXPECT_NEAR(on, 360.0 * 5.5, 60.0) << machine.name; // only the turns of the rows
      EXPECT_GT(largest_off, 300.0) << machine.name;
    }
    EXPECT_GE(broken, 1U) << machine.name;
    EXPECT_LE(broken, 3U) << machine.name;
  }
}

TEST(PassCodes, WithoutThemTheProgramIsTheSame)
{
  const ScratchFolder folder;
  const MachineProgram program = programFor(testMachines()[0], threeRows());
  const auto written = [&](Dialect dialect, const ProgramHeader& header) {
    writeProgram(folder.path("a.nc"), program, dialect, header);
    const std::string text = readText(folder.path("a.nc"));
    return dialect == Dialect::Heidenhain ? std::regex_replace(text, std::regex("(^|\n)[0-9]+ "), "$1") : text;
  };
  for (const Dialect dialect : dialects) {
    const std::string plain = written(dialect, {"rows", 0.0, 0, 4}), codes = written(dialect, withCodes());
    EXPECT_EQ(plain.find(on_code), std::string::npos);
    EXPECT_EQ(plain.find(off_code), std::string::npos);
    EXPECT_TRUE(std::regex_replace(codes, std::regex(on_code + "\n|" + off_code + "\n"), "") == plain);
    EXPECT_NE(codes, plain);
    ProgramHeader one = withCodes();
    one.pass_begin.clear(); // either one can be left out
    EXPECT_TRUE(std::regex_replace(codes, std::regex(on_code + "\n"), "") == written(dialect, one));
  }
}

TEST(PassCodes, OfARowThatEndsTheProgramTheEndStandsToo)
{
  const ScratchFolder folder;
  MachineProgram program = programFor(testMachines()[0], threeRows());
  while (program.blocks.back().section != BlockSection::Cut)
    program.blocks.pop_back();
  for (const Dialect dialect : dialects) {
    writeProgram(folder.path("a.nc"), program, dialect, withCodes());
    const ParsedProgram read = parsed(folder.path("a.nc"), dialect);
    ASSERT_EQ(read.placesOf(off_code).size(), 3U);
    EXPECT_EQ(read.placesOf(off_code).back(), program.blocks.size());
  }
}

TEST(PassCodes, LinuxCNCSwitchesTheOutputOnceARow)
{
  const ScratchFolder folder;
  const std::vector<ToolPoses> rows = threeRows();
  const std::string file = folder.path("rows.ngc");
  for (const bool rtcp : {true, false})
    for (const bool limited : {false, true}) {
      Machine machine = limited ? withLimits(testMachines()[0]) : testMachines()[0];
      machine.rtcp = rtcp;
      writeLinuxCNC(file, programFor(machine, rows), withCodes());
      const CanonicalRun run = interpret(file, folder);
      EXPECT_EQ(run.code, 0);
      EXPECT_EQ(run.messages, "");
      for (const CanonicalOutput& output : run.outputs)
        EXPECT_EQ(output.bit, 0);
      const std::size_t broken = expectBeamsOnRows(machine, asProgram(run), rows);
      EXPECT_EQ(run.outputs.size(), 2 * (rows.size() + broken));
      EXPECT_EQ(broken > 0, limited);
    }
}

TEST(PassCodes, WhatIsNoLineOfAProgramIsRefused)
{
  const ScratchFolder folder;
  const std::string file = folder.path("a.nc");
  const MachineProgram program = programFor(testMachines()[0], threeRows());
  const std::pair<std::string, std::string> wrong[] = {{"M62 P0\nM3", "line break"},
                                                       {"M62\r", "line break"},
                                                       {"\tM62", "special character"},
                                                       {"M62 \x80", "special character"},
                                                       {"M62 (beam", "has ("},
                                                       {"M62 beam)", "has )"},
                                                       {"M62 ; beam", "has ;"},
                                                       {"%", "has %"},
                                                       {"  ", "has only spaces"},
                                                       {std::string(81, 'M'), "80"},
                                                       {std::string("M\0", 2), "special character"}};
  for (const auto& [code, words] : wrong)
    for (const bool begin : {true, false})
      for (const Dialect dialect : dialects) {
        ProgramHeader header = withCodes();
        (begin ? header.pass_begin : header.pass_end) = code;
        try {
          writeProgram(file, program, dialect, header);
          ADD_FAILURE() << "written with " << code;
        }
        catch (const FileError& error) {
          const std::string message = error.what();
          EXPECT_NE(message.find(words), std::string::npos) << message;
          EXPECT_NE(message.find("; give one line such as M62 P0"), std::string::npos) << message;
          EXPECT_TRUE(std::none_of(message.begin(), message.end(), [](unsigned char c) { return c < ' ' || c > '~'; })) << message;
        }
        EXPECT_EQ(folder.count(), 0U);
      }
  for (const std::string code : {"M62 P0", "$A_OUT[1]=1", "M101", "H=Beam_on"}) {
    EXPECT_EQ(faultOfCode(code), "");
    ProgramHeader header = withCodes();
    header.pass_begin = code;
    writeProgram(file, program, Dialect::Siemens, header);
    EXPECT_EQ(parseSiemens(file).placesOf(code).size(), 3U);
  }
}

} // namespace pass_codes_test
