// SPDX-License-Identifier: BSD-3-Clause
// The controls of the tests themselves: a short program as each control's handbook has it runs, and each planted fault is
// refused by name.
#include "support/control_angles.h"
#include "support/control_job.h"
#include "support/planted_faults.h"
#include "support/reached_poses.h"

#include <gtest/gtest.h>

#include <random>
#include <regex>
#include <sstream>

namespace control_run_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

const double sphere = 100.0, ball = 6.0, retract = 350.0;

ControlJob
tiltingTable()
{
  ControlJob job = jobOf(testMachines()[0]);
  job.linear = {{{-400.0, 400.0, 20000.0}, {-400.0, 400.0, 20000.0}, {-100.0, 600.0, 20000.0}}};
  job.rotary[1].lower = -100.0;
  job.rotary[1].upper = 120.0;
  job.tool = 3;
  job.coolant = "M8";
  job.retract_z = retract;
  job.tool_tip = true;
  job.largest_feed = 1500.0;
  job.clearance = clearanceOfDome(sphere, ball, ball, 80.0);
  return job;
}

/** A short pass of a ball, its axis along the normal of the dome. */
ToolPoses
shortPass()
{
  ToolPoses poses;
  for (int i = 0; i <= 6; ++i) {
    const double polar = 0.25, round = 0.5 + 0.03 * i;
    ToolPose pose;
    pose.normal = pose.axis = {std::sin(polar) * std::cos(round), std::sin(polar) * std::sin(round), std::cos(polar)};
    pose.tip = pose.contact = sphere * pose.normal - Eigen::Vector3d(0.0, 0.0, sphere);
    poses.push_back(pose);
  }
  return poses;
}

/** One line of the program under tool-tip control. */
struct Step {
  Eigen::Vector3d tip, axis;
  std::array<double, 2> degrees;
  double minutes; ///< 0: a rapid
};

std::vector<Step>
stepsOf(const ControlJob& job)
{
  const ToolPoses poses = shortPass();
  std::vector<Step> steps;
  std::array<double, 2> degrees{};
  const auto add = [&](const Eigen::Vector3d& tip, const Eigen::Vector3d& axis, double minutes) {
    degrees = nearestAngles(job.set, axis, degrees);
    steps.push_back({tip, axis, degrees, minutes});
  };
  const auto top = [&](const ToolPose& pose) {
    degrees = nearestAngles(job.set, pose.axis, degrees);
    Eigen::Vector3d gauge = gaugeFor(job.set, pose.tip + 50.0 * pose.axis, degrees);
    gauge.z() = retract;
    add(toolAt(job.set, {gauge, degrees}).tip, pose.axis, 0.0);
  };
  top(poses.front());
  add(poses.front().tip + 50.0 * poses.front().axis, poses.front().axis, 0.0);
  add(poses.front().tip + 5.0 * poses.front().axis, poses.front().axis, 0.0);
  for (const ToolPose& pose : poses)
    add(pose.tip, pose.axis, 0.005);
  add(poses.back().tip + 50.0 * poses.back().axis, poses.back().axis, 0.0);
  return steps;
}

std::string
number(const std::string& name, double value, int decimals = 6, bool sign = false)
{
  std::ostringstream text;
  text << ' ' << name << std::fixed << (sign ? std::showpos : std::noshowpos);
  text.precision(decimals);
  text << value;
  return text.str();
}

std::string
threeWords(const std::array<const char*, 3>& names, const Eigen::Vector3d& v, int decimals, bool sign = false)
{
  return number(names[0], v.x(), decimals, sign) + number(names[1], v.y(), decimals, sign) + number(names[2], v.z(), decimals, sign);
}

/** The moves of a program, and what stands between its fixed lines. */
struct Moves {
  std::string rotary_start, over_start, place_start, blocks;
};

Moves
movesOf(const ControlJob& job, Dialect dialect)
{
  const bool klartext = dialect == Dialect::Heidenhain;
  const std::vector<Step> steps = stepsOf(job);
  const auto angles = [&](const Step& step) {
    return number("A", step.degrees[1], 6, klartext) + number("C", step.degrees[0], 6, klartext);
  };
  const auto place = [&](const Step& step) {
    const std::string xyz = threeWords({"X", "Y", "Z"}, step.tip, 6, klartext);
    switch (dialect) {
    case Dialect::FanucVectors:
      return xyz + threeWords({"I", "J", "K"}, step.axis, 8);
    case Dialect::Siemens:
      return xyz + threeWords({"A3=", "B3=", "C3="}, step.axis, 8);
    case Dialect::Heidenhain:
      return xyz + threeWords({"NX", "NY", "NZ"}, step.axis, 8, true) + threeWords({"TX", "TY", "TZ"}, step.axis, 8, true);
    default:
      return xyz + angles(step);
    }
  };
  const Eigen::Vector3d over = gaugeFor(job.set, steps[0].tip, steps[0].degrees) - job.set.work_zero;
  Moves moves{angles(steps[0]), number("X", over.x(), 6, klartext) + number("Y", over.y(), 6, klartext), place(steps[0]), {}};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const bool rapid = steps[i].minutes == 0.0;
    const double way = i > 0 ? (steps[i].tip - steps[i - 1].tip).norm() : 0.0;
    if (klartext)
      moves.blocks += "LN" + place(steps[i]) + (rapid ? " FMAX" : number("F", way / steps[i].minutes, 3)) + "\n";
    else
      moves.blocks += (rapid ? "G0" : "G1") + place(steps[i]) + (rapid ? "" : number("F", 1.0 / steps[i].minutes, 4)) + "\n";
  }
  return moves;
}

std::string
handWritten(const ControlJob& job, Dialect dialect)
{
  const Moves m = movesOf(job, dialect);
  switch (dialect) {
  case Dialect::LinuxCNC:
    return "(part)\nG21 G90 G17 G40 G49 G80 G94\nM429\nG53 G0 Z350.\nT3 M6\nG43\nS12000 M3\nM8\nG54\nG64 P0.005\nG0" + m.rotary_start +
           "\nG0" + m.over_start + "\nM428\nG93\n" + m.blocks + "G94\nM429\nG53 G0 Z350.\nM5\nM9\nM2\n";
  case Dialect::Fanuc:
  case Dialect::FanucVectors:
    return "%\nO0001 (part)\nG21 G90 G94 G17 G40 G49 G80\nG0 G53 Z350.\nT3 M6\nS12000 M3\nM8\nG54\nG5.1 Q1\nG0" + m.rotary_start + "\nG0" +
           m.over_start + "\n" + (dialect == Dialect::Fanuc ? "G43.4" : "G43.5") + " H3" + m.place_start + "\nG93\n" + m.blocks +
           "G94\nG49\nG0 G53 Z350.\nM5\nM9\nG5.1 Q0\nM30\n%\n";
  case Dialect::Siemens:
    return "; part\nG71 G90 G94 G17 G40\nSUPA G0 Z350 D0\nT3 M6\nS12000 M3\nM8\nG54 D1\nCYCLE832(0.005,_ORI_FINISH,0.5)\nG0" +
           m.rotary_start + "\nG0" + m.over_start + "\nTRAORI\nG54\nORIWKS\nORIVECT\nG93\n" + m.blocks +
           "G94\nTRAFOOF\nSUPA G0 Z350 D0\nM5\nM9\nCYCLE832(0,_OFF,1)\nM30\n";
  default:
    return withFault(
        "0 BEGIN PGM part MM\n1 ; part\n2 L Z+350 R0 FMAX M91\n3 TOOL CALL 3 Z S12000\n4 M3\n5 M8\n"
        "6 CYCL DEF 247 DATUM SETTING Q339=+1\n7 CYCL DEF 32.0 TOLERANCE\n8 CYCL DEF 32.1 T0.005\n"
        "9 CYCL DEF 32.2 HSC-MODE:0 TA0.5\n10 L" +
            m.rotary_start + " R0 FMAX\n11 L" + m.over_start + " R0 FMAX\n12 M128\n" +
            std::regex_replace(m.blocks, std::regex("LN"), "- LN") +
            "- M129\n- L Z+350 R0 FMAX M91\n- M5\n- M9\n- CYCL DEF 32.0 TOLERANCE\n- CYCL DEF 32.1\n- M30\n- END PGM part MM\n",
        dialect, {"", [](std::vector<std::string>&) { return true; }, ""});
  }
}

ControlJob
jobFor(Dialect dialect)
{
  ControlJob job = tiltingTable();
  if (dialect == Dialect::Heidenhain)
    job.offset = "1";
  return job;
}

} // namespace

TEST(ControlRun, AProgramWrittenByHandRunsToItsEnd)
{
  for (const DialectEntry& entry : dialect_entries) {
    const ControlJob job = jobFor(entry.dialect);
    const ControlRun run = runProgram(handWritten(job, entry.dialect), entry.dialect, job);
    EXPECT_EQ(run.fault, "") << entry.word << "\n" << handWritten(job, entry.dialect);
    EXPECT_EQ(missedPose(run, {{shortPass()}, ball, {}}), "") << entry.word;
  }
}

TEST(ControlRun, EveryPlantedFaultIsNamed)
{
  for (const DialectEntry& entry : dialect_entries) {
    const ControlJob job = jobFor(entry.dialect);
    for (const PlantedFault& fault : plantedFaults(entry.dialect, "AC")) {
      const std::string text = withFault(handWritten(job, entry.dialect), entry.dialect, fault);
      ASSERT_NE(text, "") << entry.word << ": no place for: " << fault.name;
      const ControlRun run = runProgram(text, entry.dialect, job);
      if (!fault.words.empty())
        EXPECT_NE(run.fault.find(fault.words), std::string::npos) << entry.word << ", " << fault.name << ": " << run.fault;
      else
        EXPECT_TRUE(!run.fault.empty() || !missedPose(run, {{shortPass()}, ball, {}}).empty() || std::abs(feedMinutes(run) - 0.035) > 0.005)
            << entry.word << ", " << fault.name;
    }
  }
}

TEST(ControlRun, AnotherLengthOrPlaceInTheControlMissesThePath)
{
  for (const DialectEntry& entry : dialect_entries) {
    ControlJob job = jobFor(entry.dialect);
    const std::string text = handWritten(job, entry.dialect);
    job.gouge = job.first_step = 5.0;
    job.set.tool_length += 1.0; // the cutter comes 1 mm short of what the tool table has
    EXPECT_NE(missedPose(runProgram(text, entry.dialect, job), {{shortPass()}, ball, {}}).find(" 1 along the tool"), std::string::npos);
    job.set.tool_length -= 2.0;
    EXPECT_NE(missedPose(runProgram(text, entry.dialect, job), {{shortPass()}, ball, {}}).find(" -1 along the tool"), std::string::npos);
    job.gouge = 0.01;
    EXPECT_NE(runProgram(text, entry.dialect, job).fault.find("enters the part"), std::string::npos);
    job = jobFor(entry.dialect);
    job.gouge = job.first_step = 5.0;
    job.set.work_zero.x() += 1.0;
    EXPECT_NE(missedPose(runProgram(text, entry.dialect, job), {{shortPass()}, ball, {}}).find("the tip is off by "), std::string::npos);
  }
}

TEST(ControlRun, TheAnglesOfAVectorReachIt)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> turn(-700.0, 700.0), tilt(-80.0, 80.0), place(-100.0, 100.0);
  for (const Machine& machine : testMachines())
    for (int i = 0; i < 200; ++i) {
      const MachineChain chain = chainOf(machine);
      const AxisPosition at{{place(random), place(random), place(random)}, {turn(random), tilt(random)}};
      const TipAndAxis tool = toolAt(chain, at);
      const std::array<double, 2> from = {at.degrees[0] + 20.0 * tilt(random) / 80.0, at.degrees[1]};
      const std::array<double, 2> found = nearestAngles(chain, tool.axis, from);
      const double turned = std::abs(found[0] - from[0]) + std::abs(found[1] - from[1]);
      EXPECT_LE(turned, std::abs(at.degrees[0] - from[0]) + 1e-4) << "no further than the way back to where it was";
      const Eigen::Vector3d gauge = gaugeFor(chain, tool.tip, found);
      const TipAndAxis again = toolAt(chain, {gauge, found});
      EXPECT_LT((again.tip - tool.tip).norm(), 1e-9);
      EXPECT_LT((again.axis - tool.axis).norm(), 1e-7);
    }
}

} // namespace control_run_test
