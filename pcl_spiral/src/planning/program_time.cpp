// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/planning/program_time.h>

#include <algorithm>

namespace pcl_spiral {
namespace {

constexpr double axis_per_tip = 0.5; ///< radians a mm: of the tolerances of thinning, as in BlockTolerance

/** The program with blocks left out within \p tolerance; empty if it cannot be made. */
MachineProgram
thinned(ProgramPlanner& planner, double tolerance)
{
  ProgramSettings settings = planner.getSettings();
  settings.thinning.tip = std::max(settings.thinning.tip, tolerance);
  settings.thinning.axis = std::max(settings.thinning.axis, axis_per_tip * tolerance);
  planner.setSettings(settings);
  planner.setCheckLeads(false); // they stay where they are
  planner.setProgressCallback({});
  planner.setQuiet(true);
  MachineProgram program;
  planner.compute(program);
  return program;
}

} // namespace

MotionStudy
studyProgram(ProgramPlanner planner, const MachineProgram& program, ControlKind kind, double tolerance)
{
  const ControlModel control = controlModel(kind, program.machine);
  MotionStudy study = studyMotion(program, control, tolerance);
  if (!study.status.ok() || !(study.tolerance > 0.0))
    return study;
  if (const auto time = motionTime(thinned(planner, study.tolerance), control, study.tolerance); time && !time->blocks.empty())
    study.gains.push_back({MotionChange::ChordError, study.time.seconds - time->seconds});
  sortGains(study.gains);
  return study;
}

} // namespace pcl_spiral
