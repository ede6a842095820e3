// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Paths over a dome, machines with limits, and their programs for the controls of the tests.
 */
#pragma once

#include "support/control_run.h"

#include <pcl_spiral/machine/machine_program_generator.h>

#include <string>
#include <vector>

namespace pcl_spiral::test {

/** A path over a ball-shaped part with its top at zero, and its cutter. */
struct DomeScene {
  std::string name;
  std::vector<ToolPoses> passes;
  double sphere = 200.0;
  double radius = 6.0, corner = 6.0;          ///< of the cutter
  double lower = -INFINITY, upper = INFINITY; ///< of the first rotary axis, degrees

  bool isBall() const { return radius == corner; }
};

DomeScene spiralFromThePole();
DomeScene finiteAxis();     ///< the first axis turns back a few times
DomeScene threePasses();    ///< away from the pole
DomeScene bullNosePasses(); ///< rows of a leaning bull-nose cutter
DomeScene uprightSpiral();  ///< the tool axis along +Z
DomeScene tiltedSpiral();   ///< one leaning tool axis at every point
/** The same from the other end. */
DomeScene reversed(DomeScene scene);

/** Tilting table, fork head, head over a table, nutating head: with travels, speeds and a height for the retract. */
std::vector<Machine> limitedMachines(const DomeScene& scene);
Machine threeAxisMill();

MachineProgram programOf(const DomeScene& scene, const Machine& machine);
/** What a program for \p machine says beside its moves. */
ProgramHeader headerOf();
/** The text of the program. */
std::string textOf(const MachineProgram& program, Dialect dialect, const ProgramHeader& header);
/** The shop that runs it. */
ControlJob jobOf(const DomeScene& scene, const Machine& machine, Dialect dialect);

/** The minutes at feed that \p text, the program in its language, gives the control. */
double writtenMinutes(const MachineProgram& program, Dialect dialect, const std::string& text);

/** Runs the program to its end: every pose is passed, the axes stand where they were planned, and the time is that of the report. */
void expectRuns(const DomeScene& scene, const MachineProgram& program, Dialect dialect, const ProgramHeader& header, const ControlJob& job);

} // namespace pcl_spiral::test
