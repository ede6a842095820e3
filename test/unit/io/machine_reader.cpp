// SPDX-License-Identifier: BSD-3-Clause
// Machine files: the files of the programs, and the error messages of wrong files.
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/machine_reader.h>

#include "support/scratch_folder.h"

#include <gtest/gtest.h>

#include <cmath>

namespace machine_reader_test {

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
  EXPECT_FALSE(m.path_tolerance.has_value());
  EXPECT_EQ(m.words.tip_control_on, "M428");
  EXPECT_EQ(m.words.tip_control_off, "M429");
  const Machine fork = readMachine(machines + "/head_head.yaml");
  EXPECT_EQ(fork.rotary[1].mount, RotaryMount::Head);
  EXPECT_EQ(fork.rotary[1].point.z(), 150.0);
  EXPECT_NEAR(fork.rotary[0].range.upper, 720.0 * degree, 1e-12);
  EXPECT_EQ(fork.retract_z, 1200.0);
  EXPECT_EQ(readMachine(machines + "/xyzbc.yaml").rotary[1].letter, 'B');
  EXPECT_FALSE(readMachine(machines + "/head_table.yaml").rtcp);
}

TEST(MachineReader, LinesOfTheShopAndWordsOfTheControlAreRead)
{
  const ScratchFolder folder;
  writeText(folder.path("m.yaml"), whole + "path_tolerance: 0.02\n"
                                           "program:\n"
                                           "  header: [\"M98 P9000\", \"(part {part}, {spindle} rev/min)\"]\n"
                                           "  footer: M98 P9001\n"
                                           "  pass_begin: [M62 P0]\n"
                                           "  pass_end: [M63 P0]\n"
                                           "  coolant: {mist: M107, flood: M108, through: M88, off: M109}\n"
                                           "  kinematics: {on: M68 E3 Q0, off: M68 E3 Q1}\n"
                                           "  smoothing: {on: [\"G8 P1\"], off: []}\n");
  const Machine m = readMachine(folder.path("m.yaml"));
  EXPECT_EQ(m.path_tolerance, 0.02);
  EXPECT_EQ(m.lines.header, (std::vector<std::string>{"M98 P9000", "(part {part}, {spindle} rev/min)"}));
  EXPECT_EQ(m.lines.footer, std::vector<std::string>{"M98 P9001"});
  EXPECT_EQ(m.lines.pass_begin, std::vector<std::string>{"M62 P0"});
  EXPECT_EQ(m.lines.pass_end, std::vector<std::string>{"M63 P0"});
  EXPECT_EQ(m.words.mist + m.words.flood + m.words.through + m.words.coolant_off, "M107M108M88M109");
  EXPECT_EQ(m.words.tip_control_off, "M68 E3 Q1");
  EXPECT_EQ(m.words.smoothing_on, std::vector<std::string>{"G8 P1"});
  EXPECT_EQ(m.words.smoothing_off, std::vector<std::string>{});
}

TEST(MachineReader, LimitsOfAccelerationAndJerkAreRead)
{
  const ScratchFolder folder;
  writeText(folder.path("m.yaml"), replaced("max_rpm: 10", "max_rpm: 10, max_acceleration: 500, max_jerk: 9000") +
                                       "linear: {X: {max_acceleration: 1500, max_jerk: 30000}}\n"
                                       "control: {look_ahead: 200, rounds_rotary_corners: true}\n");
  const Machine m = readMachine(folder.path("m.yaml"));
  EXPECT_NEAR(*m.rotary[1].range.largest_acceleration, 500.0 * degree, 1e-12);
  EXPECT_NEAR(*m.rotary[1].range.largest_jerk, 9000.0 * degree, 1e-12);
  EXPECT_FALSE(m.rotary[0].range.largest_acceleration);
  EXPECT_EQ(m.linear[0].largest_acceleration, 1500.0);
  EXPECT_EQ(m.linear[0].largest_jerk, 30000.0);
  EXPECT_FALSE(m.linear[1].largest_jerk);
  EXPECT_EQ(m.control.look_ahead, 200);
  EXPECT_EQ(m.control.rounds_rotary_corners, true);
  for (const char* bad : {"0", "-5"}) {
    const std::string value = bad;
    expectHas(said(whole + "linear: {Y: {max_acceleration: " + value + "}}\n"),
              "the largest acceleration of Y is " + value + "; give a number from 0.001 to ");
    expectHas(said(replaced("max_rpm: 10", "max_rpm: 10, max_jerk: " + value)), "the largest jerk of A is " + value + "; ");
    expectHas(said(whole + "control: {look_ahead: " + value + "}\n"), "the look-ahead of the control is " + value);
  }
  for (const char* bad : {"1e-300", "1e300"})
    expectHas(said(whole + "linear: {Y: {max_acceleration: " + bad + "}}\n"), "the largest acceleration of Y is ");
  expectHas(said(whole + "linear: {Y: {max_acceleration: .nan}}\n"), "max_acceleration of Y is not finite");
  expectHas(said(whole + "control: {depth: 3}\n"), "'depth' is not a setting of control; its settings are look_ahead");
}

TEST(MachineReader, WrongLinesOfTheShopAreNamed)
{
  const std::string program = whole + "program:\n  ";
  expectHas(said(program + "header: [\"M3 S{speed}\"]\n"), "line 5: the line 'M3 S{speed}' of header has {speed}, which is no name of a "
                                                           "value; the names are {spindle} {tool} {part} {safe_z}");
  expectHas(said(program + "header: [\"%\"]\n"), "has %, which ends the program");
  expectHas(said(program + "pass_begin: [M62 P0]\n"), "of pass_begin and pass_end only one is given");
  expectHas(said(program + "kinematics: {on: M428}\n"), "only one is given; give both, such as M428 and M429");
  expectHas(said(program + "coolant: {air: M7}\n"), "'air' is not a setting of coolant; its settings are mist, flood, through, off");
}

TEST(MachineReader, ConventionalDirectionsTurnTablesAlone)
{
  const ScratchFolder folder;
  writeText(folder.path("m.yaml"), "conventional_directions: true\n" + replaced("axis: A, mount: table", "axis: A, mount: head"));
  const Machine m = readMachine(folder.path("m.yaml"));
  EXPECT_EQ(m.rotary[0].direction, Eigen::Vector3d(0, 0, -1));
  EXPECT_EQ(m.rotary[1].direction, Eigen::Vector3d(1, 0, 0));
}

TEST(MachineReader, AThreeAxisMachineHasNoRotaryAxes)
{
  const Machine m = readMachine(machines + "/three_axes.yaml");
  EXPECT_TRUE(m.three_axes);
  EXPECT_FALSE(m.takesTips());
  expectHas(said("rotary: [{axis: C}]\n"), "or [] for a machine with three axes");
}

/** Without RTCP a program holds places of the axes, and a place that the file leaves out would be a silent guess. */
TEST(MachineReader, WithoutRtcpThePlacesOfTheAxesMustBeGiven)
{
  const auto axis = [](const char* letter, const char* mount, const char* direction, bool point) {
    return std::string("  - {axis: ") + letter + ", mount: " + mount + ", direction: " + direction + ", limits: [-100, 100], max_rpm: 10" +
           (point ? ", point: [0, 0, 5]}\n" : "}\n");
  };
  const std::string c_table = axis("C", "table", "[0, 0, 1]", true), b_head = axis("B", "head", "[0, 1, 0]", true);
  const std::string zero = "work_zero: [1, 2, 3]\n", length = "tool_length: 80\n", none = "rtcp: false\n";
  expectHas(
      said("rotary:\n" + axis("C", "table", "[0, 0, 1]", false) + b_head + zero + length + none),
      "line 2: rtcp: false, so the program depends on point, and none is given; measure it on the machine and give point: [x, y, z], a "
      "place on the axis C");
  expectHas(said("rotary:\n" + c_table + b_head + length + none),
            "depends on work_zero, and none is given; measure it on the machine and give work_zero: ");
  expectHas(said("rotary:\n" + c_table + b_head + zero + none),
            "depends on tool_length, and none is given; measure it on the machine and give tool_length: ");
  const ScratchFolder folder;
  writeText(folder.path("m.yaml"), "rotary:\n" + c_table + b_head + zero + length + none);
  EXPECT_FALSE(readMachine(folder.path("m.yaml")).rtcp);
  writeText(folder.path("m.yaml"), "rotary:\n" + c_table + axis("A", "table", "[1, 0, 0]", true) + zero + none);
  EXPECT_FALSE(readMachine(folder.path("m.yaml")).rtcp) << "two tables do not move the tool: its length is the control's affair";
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

} // namespace machine_reader_test
