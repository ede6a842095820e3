// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The time that a control needs for the program of a plan.
 */
#pragma once

#include <pcl_spiral/machine/motion_time.h>
#include <pcl_spiral/planning/program_planner.h>

namespace pcl_spiral {

/** studyMotion of \p program, which \p planner has made, on the control \p kind as the machine of the planner has it. The gain of
 *  MotionChange::ChordError is that of the program made once more, with blocks left out within \p tolerance, mm.
 *  \code
 *  ProgramPlanner planner;
 *  ...
 *  planner.compute(program);
 *  const MotionStudy study = studyProgram(planner, program, ControlKind::LinuxCNC, 0.01);
 *  \endcode */
MotionStudy studyProgram(ProgramPlanner planner, const MachineProgram& program, ControlKind kind, double tolerance);

} // namespace pcl_spiral
