// SPDX-License-Identifier: BSD-3-Clause
// The time of programs by hand: ramps, corners, look-ahead, jerk; where the time goes, and what would gain.
#include <pcl_spiral/machine/motion_time.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace motion_time_test {

namespace {

using namespace pcl_spiral;

/** Three axes with one acceleration, mm/s2. */
MachineProgram
programFrom(double acceleration)
{
  MachineProgram program;
  program.machine.three_axes = true;
  for (AxisRange& axis : program.machine.linear) {
    axis.largest_rate = 15000.0;
    axis.largest_acceleration = acceleration;
  }
  program.blocks.emplace_back();
  return program;
}

/** Adds a move by \p way at \p feed, mm/s; 0: a rapid. */
void
add(MachineProgram& program, const Eigen::Vector3d& way, double feed, RotaryAngles turn = {})
{
  ProgramBlock block = program.blocks.back();
  block.tip += way;
  block.machine += way;
  block.angles.first += turn.first;
  block.angles.second += turn.second;
  block.rapid = feed == 0.0;
  block.minutes = block.rapid ? 0.0 : way.norm() / feed / 60.0;
  program.blocks.push_back(block);
}

double
secondsOf(const MachineProgram& program, const ControlModel& control, double tolerance = 0.01)
{
  return motionTime(program, control, tolerance)->seconds;
}

/** Short moves whose direction changes by up to \p bend. */
MachineProgram
randomProgram(unsigned int seed, double bend, bool turns)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  MachineProgram program = programFrom(1000.0);
  if (turns) {
    program.machine.rotary = xyzacTrunnion().rotary;
    program.machine.three_axes = false;
  }
  double heading = 0.0;
  for (int i = 0; i < 400; ++i) {
    heading += bend * share(random);
    const double length = 0.3 * (1.2 + share(random));
    const RotaryAngles turn = turns ? RotaryAngles{0.01 * share(random), 0.005 * share(random)} : RotaryAngles();
    add(program, length * Eigen::Vector3d(std::cos(heading), std::sin(heading), 0.2 * share(random)), 80.0, turn);
  }
  return program;
}

} // namespace

TEST(MotionTime, AMoveIsATrapezoid)
{
  MachineProgram program = programFrom(1000.0);
  add(program, {50.0, 0.0, 0.0}, 100.0);
  const ControlModel stop = controlModel(ControlKind::ExactStop);
  EXPECT_NEAR(secondsOf(program, stop), 50.0 / 100.0 + 100.0 / 1000.0, 1e-12);
  program.blocks[1].minutes = 50.0 / 1000.0 / 60.0; // never reached: 250 mm/s are the most, and a triangle is slower still
  EXPECT_NEAR(secondsOf(program, stop), 2.0 * std::sqrt(50.0 / 1000.0), 1e-12);
  EXPECT_NEAR(secondsOf(program, controlModel(ControlKind::LinuxCNC), 0.0), 0.448, 1e-12) << "whole cycles";
}

TEST(MotionTime, JerkMakesAnSCurve)
{
  MachineProgram program = programFrom(1000.0);
  for (AxisRange& axis : program.machine.linear)
    axis.largest_jerk = 20000.0;
  add(program, {100.0, 0.0, 0.0}, 100.0);
  EXPECT_NEAR(secondsOf(program, controlModel(ControlKind::ExactStop)), 100.0 / 100.0 + 100.0 / 1000.0 + 1000.0 / 20000.0, 1e-9);
  program.blocks[1].minutes = 100.0 / 20.0 / 60.0; // the acceleration is not reached
  EXPECT_NEAR(secondsOf(program, controlModel(ControlKind::ExactStop)), 100.0 / 20.0 + 2.0 * std::sqrt(20.0 / 20000.0), 1e-9);
  EXPECT_NEAR(secondsOf(program, controlModel(ControlKind::Grbl)), 100.0 / 20.0 + 20.0 / 1000.0, 1e-9) << "Grbl has no jerk";
}

TEST(MotionTime, TheSpeedStopsWithinTheLookAhead)
{
  MachineProgram program = programFrom(100.0);
  for (int i = 0; i < 4000; ++i)
    add(program, {0.1, 0.0, 0.0}, 200.0);
  ControlModel control = controlModel(ControlKind::Siemens);
  control.look_ahead = 20;
  const MotionTime time = *motionTime(program, control, 0.01);
  const double least = std::sqrt(2.0 * 100.0 * 20.0 * 0.1), most = std::sqrt(2.0 * 100.0 * 21.0 * 0.1);
  EXPECT_LT(0.1 / time.blocks[2000], most);
  EXPECT_GT(0.1 / time.blocks[2000], least);
}

TEST(MotionTime, EveryRuleHasItsCornerSpeed)
{
  MachineProgram program = programFrom(2000.0);
  add(program, {100.0, 0.0, 0.0}, 1000.0 / 60.0);
  add(program, {0.0, 100.0, 0.0}, 1000.0 / 60.0);
  const auto loss = [&](const ControlModel& control) { // by a corner between moves at full speed
    ControlModel free = control;
    free.corner = CornerRule::Free;
    return secondsOf(program, control) - secondsOf(program, free);
  };
  const double f = 1000.0 / 60.0;
  const auto lost = [&](double corner) { return (f - corner) * (f - corner) / (2000.0 * f); };
  ControlModel fanuc = controlModel(ControlKind::Fanuc); // A-63512EN: 90 degrees, F1000, difference 500: the corner is at 500
  fanuc.jump_time = 500.0 / 60.0 / 2000.0;
  EXPECT_NEAR(loss(fanuc), lost(500.0 / 60.0), 1e-9);
  const double sine = std::sqrt(0.5), radius = 0.01 * sine / (1.0 - sine); // Grbl: sin(half angle)
  EXPECT_NEAR(loss(controlModel(ControlKind::Grbl)), lost(std::sqrt(2000.0 * radius)), 1e-9);
  const double d = 4.0 * 0.01 / std::sqrt(2.0); // a parabola whose vertex is 0.01 from the corner
  EXPECT_NEAR(loss(controlModel(ControlKind::Siemens)), lost(std::sqrt(2.0 * d * 2000.0)), 1e-9);
  EXPECT_NEAR(loss(controlModel(ControlKind::ExactStop)), lost(0.0), 1e-9);
}

TEST(MotionTime, TheMachineSaysHowItsControlDiffers)
{
  Machine machine = xyzacTrunnion();
  EXPECT_EQ(controlModel(ControlKind::LinuxCNC, machine).rotary_corner, CornerRule::Overlap);
  machine.control.look_ahead = 7;
  machine.control.rounds_rotary_corners = true;
  EXPECT_EQ(controlModel(ControlKind::LinuxCNC, machine).look_ahead, 7U);
  EXPECT_EQ(controlModel(ControlKind::LinuxCNC, machine).rotary_corner, CornerRule::AxisRounding);
  machine.control.rounds_rotary_corners = false;
  EXPECT_EQ(controlModel(ControlKind::Siemens, machine).rotary_corner, CornerRule::Stop);
  MachineProgram program = randomProgram(3, 0.1, false);
  const double loose = secondsOf(program, controlModel(ControlKind::LinuxCNC), 0.01);
  program.machine.path_tolerance = 0.0;
  EXPECT_GT(secondsOf(program, controlModel(ControlKind::LinuxCNC), 0.01), 1.5 * loose) << "the machine's own tolerance counts";
}

TEST(MotionTime, NoBlockIsFasterThanItsFeedAndPartsMakeTheWhole)
{
  for (const bool turns : {false, true})
    for (unsigned int seed = 1; seed < 6; ++seed) {
      const MachineProgram program = randomProgram(seed, 0.05 * seed, turns);
      for (const ControlModel& control : controlModels()) {
        const MotionStudy study = studyMotion(program, control, 0.01);
        ASSERT_TRUE(study.status.ok());
        EXPECT_EQ(study.usual_axes, turns);
        EXPECT_NEAR(std::accumulate(study.time.blocks.begin(), study.time.blocks.end(), 0.0), study.time.seconds, 1e-9);
        double at_feed = 0.0;
        for (const ProgramBlock& block : program.blocks)
          at_feed += 60.0 * block.minutes;
        EXPECT_GT(study.time.seconds, 0.98 * at_feed) << control.name; // arcs cut corners
        const MotionLosses& l = study.losses;
        EXPECT_NEAR(l.at_feed + l.ramps + l.corners + l.short_blocks + l.rotary, study.time.seconds, 1e-9);
        EXPECT_GE(l.ramps, 0.0);
        for (std::size_t i = 1; i < study.gains.size(); ++i)
          EXPECT_GE(study.gains[i - 1].seconds, study.gains[i].seconds);
      }
    }
}

TEST(MotionTime, AGainIsTheTimeOfTheChangedProgram)
{
  const MachineProgram program = randomProgram(2, 0.2, true);
  const ControlModel control = controlModel(ControlKind::LinuxCNC);
  const MotionStudy study = studyMotion(program, control, 0.01);
  MachineProgram faster = program, stronger = program;
  for (ProgramBlock& block : faster.blocks)
    block.minutes /= 1.5;
  for (AxisRange& axis : stronger.machine.linear)
    axis.largest_acceleration = 2000.0;
  for (RotaryAxis& axis : stronger.machine.rotary)
    axis.range.largest_acceleration = 2.0 * usual_rotary_acceleration;
  for (const MotionGain& gain : study.gains) {
    const double now = study.time.seconds;
    if (gain.change == MotionChange::Feed)
      EXPECT_NEAR(gain.seconds, now - secondsOf(faster, control), 1e-9);
    if (gain.change == MotionChange::Acceleration)
      EXPECT_NEAR(gain.seconds, now - secondsOf(stronger, control), 1e-9);
    if (gain.change == MotionChange::Tolerance)
      EXPECT_NEAR(gain.seconds, now - secondsOf(program, control, 0.02), 1e-9);
  }
  EXPECT_EQ(study.gains.size(), 4U);
  EXPECT_GT(study.losses.rotary, 0.3 * study.time.seconds) << "LinuxCNC stops at rotary moves";
}

TEST(MotionTime, PlacesAndTimesThatNoProgramHasAreRefused)
{
  const MachineProgram whole = randomProgram(1, 0.1, true);
  MachineProgram no_place = whole, negative = whole;
  no_place.blocks[7].tip.y() = std::numeric_limits<double>::quiet_NaN();
  negative.blocks[7].minutes = -0.01;
  for (const MachineProgram& program : {no_place, negative}) {
    EXPECT_FALSE(motionTime(program, controlModel(ControlKind::LinuxCNC)));
    const MotionStudy study = studyMotion(program, controlModel(ControlKind::LinuxCNC));
    EXPECT_EQ(study.status.code(), StatusCode::InvalidInput);
    EXPECT_EQ(study.status.message(), "block 7 of the program has no finite place, or a time that is not finite or below 0, so that the "
                                      "machining time is not known; set them");
  }
  EXPECT_EQ(motionTime(MachineProgram(), controlModel(ControlKind::Fanuc))->seconds, 0.0);
}

TEST(MotionTime, RapidsInALineOnAMachineWithoutLimitsTakeAFiniteTime)
{
  MachineProgram program = programFrom(1000.0);
  for (AxisRange& axis : program.machine.linear)
    axis.largest_rate = std::numeric_limits<double>::infinity();
  for (const double way : {30.0, 20.0, 50.0})
    add(program, {0.0, 0.0, way}, 0.0);
  const double seconds = secondsOf(program, controlModel(ControlKind::LinuxCNC));
  EXPECT_GE(seconds, 2.0 * std::sqrt(100.0 / 1000.0)); // from rest to rest
  EXPECT_LT(seconds, 4.0 * std::sqrt(100.0 / 1000.0));
}

TEST(MotionTime, WithoutRotaryMovesNothingIsLostToRotaryAxes)
{
  MachineProgram program = programFrom(1000.0);
  for (int i = 0; i < 20; ++i)
    add(program, {5.0, i % 2 ? 1.0 : -1.0, 0.0}, 100.0);
  add(program, {0.0, 0.0, 100.0}, 0.0);
  const MotionStudy study = studyMotion(program, controlModel(ControlKind::LinuxCNC), 0.01);
  EXPECT_EQ(study.losses.rotary, 0.0);
  for (const MotionGain& gain : study.gains)
    EXPECT_NE(gain.change, MotionChange::RotaryBlend);
}

} // namespace motion_time_test
