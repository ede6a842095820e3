// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The result of a program that makes passes of a tool.
 */
#pragma once

#include "terminal/scan_side.h"

#include <pcl_spiral/machine/machine_program.h>
#include <pcl_spiral/machine/motion_time.h>
#include <pcl_spiral/machine/tool_moves.h>
#include <pcl_spiral/planning/pass_plan.h>

#include <optional>
#include <vector>

/** Passes and what is made of them. */
struct PassResult : pcl_spiral::PassPlan {
  ScanSide asked_side;                               ///< what decides the side of the scan
  std::optional<pcl_spiral::MachineProgram> program; ///< if a machine is given
  std::optional<pcl_spiral::MotionStudy> motion;     ///< of the program
  std::vector<pcl_spiral::ToolMoves> moves;          ///< with leads, if an output is CLDATA or has robot frames
};
