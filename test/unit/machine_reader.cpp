// SPDX-License-Identifier: BSD-3-Clause
// Machine files: the files of the programs, and the error messages of wrong files.
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/machine_reader.h>

#include "support/scratch_folder.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace pcl_spiral;

namespace {

const std::string machines = PCL_SPIRAL_MACHINES_DIR;
constexpr double degree = M_PI / 180.0;

const std::string whole = "rotary:\n"
                          "  - {axis: C, mount: table, direction: [0, 0, 1], limits: unlimited, max_rpm: 20}\n"
                          "  - {axis: A, mount: table, direction: [1, 0, 0], limits: [-100, 50], max_rpm: 10}\n";

/** The error message for \p text as a machine file. */
std::string
said(const std::string& text)
{
  const ScratchFolder folder;
  writeText(folder.path("m.yaml"), text);
  try {
    readMachine(folder.path("m.yaml"));
  }
  catch (const FileError& error) {
    return error.what();
  }
  ADD_FAILURE() << "read: " << text;
  return "";
}

void
expectHas(const std::string& text, const std::string& part)
{
  EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' in: " << text;
}

std::string
replaced(const std::string& part, const std::string& by)
{
  std::string text = whole;
  return text.replace(text.find(part), part.size(), by);
}

} // namespace

TEST(MachineReader, ReadsEveryLineOfAFile)
{
  const Machine m = readMachine(machines + "/xyzac.yaml");
  EXPECT_EQ(m.name, "xyzac-trt");
  EXPECT_EQ(m.rotary[0].letter, 'C');
  EXPECT_EQ(m.rotary[0].mount, RotaryMount::Table);
  EXPECT_FALSE(m.rotary[0].range.finite());
  EXPECT_NEAR(m.rotary[0].range.largest_rate, 30.0 * 2.0 * M_PI, 1e-12);
  EXPECT_EQ(m.rotary[1].letter, 'A');
  EXPECT_EQ(m.rotary[1].direction, Eigen::Vector3d::UnitX());
  EXPECT_EQ(m.rotary[1].point, Eigen::Vector3d(0, 20, 10));
  EXPECT_NEAR(m.rotary[1].range.lower, -100.0 * degree, 1e-12);
  EXPECT_NEAR(m.rotary[1].range.upper, 120.0 * degree, 1e-12);
  EXPECT_EQ(m.linear[2].lower, -400.0);
  EXPECT_EQ(m.linear[2].upper, 600.0);
  EXPECT_EQ(m.linear[0].largest_rate, 15000.0);
  EXPECT_EQ(m.work_zero, Eigen::Vector3d(0, 0, 40));
  EXPECT_EQ(m.tool_length, 0.0);
  EXPECT_TRUE(m.rtcp);
  EXPECT_FALSE(m.retract_z.has_value());
  EXPECT_EQ(m.path_tolerance, 0.01);
  const Machine fork = readMachine(machines + "/head_head.yaml");
  EXPECT_EQ(fork.rotary[1].mount, RotaryMount::Head);
  EXPECT_EQ(fork.rotary[1].point.z(), 150.0);
  EXPECT_NEAR(fork.rotary[0].range.upper, 720.0 * degree, 1e-12);
  EXPECT_EQ(fork.retract_z, 1200.0);
  EXPECT_EQ(readMachine(machines + "/xyzbc.yaml").rotary[1].letter, 'B');
  EXPECT_FALSE(readMachine(machines + "/head_table.yaml").rtcp);
}

TEST(MachineReader, ALeastFileIsNamedByItself)
{
  const ScratchFolder folder;
  writeText(folder.path("my_mill.yaml"), whole);
  const Machine m = readMachine(folder.path("my_mill.yaml"));
  EXPECT_EQ(m.name, "my_mill");
  EXPECT_FALSE(m.linear[0].finite());
}

TEST(MachineReader, WhatIsWrongIsSaidWithItsLine)
{
  EXPECT_THROW(readMachine("/nowhere/m.yaml"), FileError);
  expectHas(said("name: [1\n"), "m.yaml: ");
  expectHas(said("- 1\n"), "line 1: a machine file needs lines");
  expectHas(said("name: a\n"), "has no rotary");
  expectHas(said(whole + "tool_lenght: 5\n"), "line 4: 'tool_lenght' is not a setting of a machine file; its settings are rotary");
  expectHas(said(replaced("max_rpm: 20", "max_rmp: 20")), "a rotary axis has no max_rpm; give it, such as max_rpm: 20");
  expectHas(said(replaced("mount: table", "mount: floor")), "line 2: mount of C is floor; it must be table or head");
  expectHas(said(replaced("[1, 0, 0]", "[1, 0]")), "line 3: direction of a rotary axis needs three numbers");
  expectHas(said(replaced("[1, 0, 0]", "[1, 0, x]")), "line 3: direction of a rotary axis cannot be read");
  expectHas(said(replaced("unlimited", "endless")), "line 2: limits of a rotary axis cannot be read");
  expectHas(said(replaced("[-100, 50]", "[50, -100]")), "lower limit of A is not below the upper one");
  expectHas(said(replaced("axis: A", "axis: C")), "both rotary axes are called C");
  expectHas(said(replaced("max_rpm: 10", "max_rpm: .inf")), "line 3: max_rpm of a rotary axis is not finite");
  expectHas(said(replaced("max_rpm: 10", "max_rpm: -1")), "largest rate of A");
  expectHas(said("rotary: [{axis: C}]\n"), "list of the two rotary axes");
  expectHas(said(whole + "linear:\n  X: {limits: [0, 1], feed: 3}\n"), "line 5: 'feed' is not a setting of X");
  expectHas(said(whole + "linear: {Q: {}}\n"), "'Q' is not a setting of linear; its settings are X, Y, Z");
  expectHas(said(whole + "work_zero: 5\n"), "line 4: work_zero of a machine file cannot be read");
  expectHas(said(whole + "rtcp: perhaps\n"), "line 4: rtcp");
  expectHas(said(whole + "linear:\n  Z: {limits: [-100, 900]}\nretract_z: -5000\n"),
            "retract_z is -5000, beyond the limits of Z, -100 to 900");
  expectHas(said(whole + "[1, 2]: 3\n"), "m.yaml: ");
}
