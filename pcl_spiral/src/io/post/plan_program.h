// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What a program says of the plan it was made from, and what it needs beside it: the same for all faces of the library.
 */
#pragma once

#include "planning/idle_settings.h"
#include <pcl_spiral/io/program_writer.h>
#include <pcl_spiral/machine/machine.h>
#include <pcl_spiral/planning/pass_plan.h>
#include <pcl_spiral/spiral/spiral_settings.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl_spiral {

/** What a program says of its path: comments, and the chord error to which the control may round corners, mm. */
struct ProgramTexts {
  std::string title;
  std::vector<std::string> notes;
  double chord_error = 0.0;
};

/** Of a spiral. */
ProgramTexts programTexts(const SpiralSettings& settings, const std::string& title);
/** Of passes; \p feed in mm/min. */
ProgramTexts programTexts(const PassSettings& settings, double feed, const std::string& title);

/** \p asked with these texts and the name of the \p machine_file; empty: there is none. \p smoothing in mm; none: the chord error. */
ProgramHeader headerOf(ProgramHeader asked, const ProgramTexts& texts, const std::string& machine_file,
                       const std::optional<double>& smoothing);

/** What the program \p output cannot be written without; empty: nothing. \p has_dialect: whether the language of a .nc was asked for.
 *  \p tool: its number; 0: none. */
Diagnostic missingFor(const std::string& output, bool has_machine, bool has_dialect, int tool);

/** What was asked for and none of the files \p outputs holds, such as a language of none of them. \p dialect: the one asked for. */
std::optional<IdleSetting> idleOfProgram(const AskedNames& asked, const std::vector<std::string>& outputs, Dialect dialect);

/** Of a program that no machine file was given for. */
Diagnostic noMachineWarning();

/** A warning if the program \p output leaves the spindle still: no speed is given, and no line of \p machine starts it; else empty. */
Diagnostics spindleWarnings(const std::string& output, const Machine& machine, const ProgramHeader& header);

} // namespace pcl_spiral
