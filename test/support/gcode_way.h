// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The way of the tool by the text of a LinuxCNC or Fanuc program alone: words, modal state and kinematics of the tests.
 */
#pragma once

#include "support/machine_oracle.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace pcl_spiral::test {

/** How a control keeps the tip in place while the rotary axes turn. */
enum class TipControl {
  Never,
  Kinematics, ///< LinuxCNC: at the start and from M428 to M429
  Length      ///< Fanuc: from G43.4 to G49
};

/** A machine with its control. */
struct ControlledMachine {
  MachineChain chain; ///< two rotary axes, or none
  TipControl tip_control = TipControl::Never;
  double longer_tool = 0.0; ///< mm that the tool is longer than the control assumes
};

/** One straight move of all axes. */
struct AxisMove {
  std::size_t line = 0; ///< of the text, from 1
  bool rapid = false;
  bool tip_control = false; ///< the tip goes straight while the rotary axes turn evenly; else X Y Z go straight
  AxisValues from, to;      ///< with tip control X Y Z are those of the tip in the frame of the workpiece
};

/** Tool at \p share of the way of a move. */
TipAndAxis placeOn(const ControlledMachine& machine, const AxisMove& move, double share);

/** Moves of a program from the first place with all axes on. 	hrow std::runtime_error a word or code that this reader does not know,
 *  with the line */
std::vector<AxisMove> movesOf(const std::string& text, const ControlledMachine& machine);

/** Calls \p visit with places along all moves, at most \p step mm of the tip and a degree apart. */
void followMoves(const std::vector<AxisMove>& moves, const ControlledMachine& machine, double step,
                 const std::function<void(const TipAndAxis&)>& visit);

} // namespace pcl_spiral::test
