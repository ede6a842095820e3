// SPDX-License-Identifier: BSD-3-Clause
// The time of a planned program, and the gain of longer blocks.
#include <pcl_spiral/io/motion_text.h>
#include <pcl_spiral/planning/program_time.h>

#include "support/spiral_jobs.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace program_time_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

TEST(ProgramTime, TheGainOfLongerBlocksIsThatOfTheProgramMadeAgain)
{
  Spiral spiral;
  spiral.setInputCloud(dome());
  spiral.setToolRadius(3.0);
  spiral.setScallopHeight(0.02);
  spiral.setFeed(4000.0);
  spiral.compute();
  ASSERT_TRUE(spiral.getStatus().ok()) << spiral.getStatus().message();
  ProgramPlanner planner;
  planner.setInputPlan(spiral.getPlan());
  planner.setMachine(xyzacTrunnion());
  MachineProgram program, longer;
  planner.compute(program);
  const double tolerance = 0.05;
  const MotionStudy study = studyProgram(planner, program, ControlKind::LinuxCNC, tolerance);
  ASSERT_TRUE(study.status.ok());
  EXPECT_TRUE(study.usual_axes);
  ProgramSettings settings = planner.getSettings();
  settings.thinning = {tolerance, 0.5 * tolerance};
  planner.setSettings(settings);
  planner.compute(longer);
  ASSERT_LT(longer.blocks.size(), program.blocks.size());
  const double seconds = motionTime(longer, study.control, tolerance)->seconds;
  const auto gain =
      std::find_if(study.gains.begin(), study.gains.end(), [](const MotionGain& one) { return one.change == MotionChange::ChordError; });
  ASSERT_NE(gain, study.gains.end());
  EXPECT_NEAR(gain->seconds, study.time.seconds - seconds, 1e-9);
  EXPECT_GT(study.losses.rotary, 0.0);
  EXPECT_NE(lossesText(study).find("% rotary axes"), std::string::npos) << lossesText(study);
  EXPECT_EQ(gainText(study).find(wordsOf(study.gains.front().change)), 0U) << gainText(study);
}

TEST(ProgramTime, AControlThatStopsExactlyGainsNothingFromATolerance)
{
  MachineProgram program;
  program.machine = xyzacTrunnion();
  program.blocks.resize(2);
  program.blocks[1].tip.x() = program.blocks[1].machine.x() = 10.0;
  program.blocks[1].minutes = 0.01;
  const MotionStudy study = studyProgram({}, program, ControlKind::LinuxCNC, 0.0);
  for (const MotionGain& gain : study.gains)
    EXPECT_TRUE(gain.change != MotionChange::ChordError && (gain.change != MotionChange::Tolerance || gain.seconds == 0.0));
}

} // namespace program_time_test
