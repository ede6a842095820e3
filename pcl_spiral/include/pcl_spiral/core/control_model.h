// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  How controls plan the speed of a program.
 */
#pragma once

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** A family of controls. */
enum class ControlKind {
  LinuxCNC,   ///< LinuxCNC 2.9
  Grbl,       ///< Grbl 1.1
  Fanuc,      ///< Fanuc with AI contour control
  Siemens,    ///< 840D with smoothing and SOFT
  Heidenhain, ///< with its look-ahead and cycle 32
  ExactStop   ///< any control that stops after every block
};

/** What a control does between two moves. */
enum class CornerRule {
  Stop,              ///< it stops
  Overlap,           ///< both moves have half their acceleration, and the next begins while this one slows down to a stop
  Arc,               ///< an arc of X Y Z within the tolerance, as fast as its centripetal acceleration allows
  AxisRounding,      ///< a parabola of all axes within the tolerance, as fast as the acceleration of each axis allows
  AxisJump,          ///< no rounding: no axis changes its speed by more than its acceleration times ControlModel::jump_time
  JunctionDeviation, ///< no rounding: the speed of an arc that would keep the tolerance
  Free               ///< corners cost nothing: a bound for comparisons
};

/** How one family of controls plans. doc/machining_time.md has the sources; only the values for LinuxCNC were checked on a planner. */
struct ControlModel {
  ControlKind kind = ControlKind::ExactStop;   ///< whose values these are
  const char* name = "";                       ///< for reports
  CornerRule corner = CornerRule::Stop;        ///< between moves whose rotary axes stand
  CornerRule rotary_corner = CornerRule::Stop; ///< before and after a move that turns a rotary axis
  bool plans_axes = true;                      ///< on the axes of the machine; false: on the coordinates of the program
  bool takes_jerk = false;                     ///< it limits the jerk if the machine has a limit
  bool stops_at_rapids = true;                 ///< between rapids and feed moves
  std::size_t look_ahead = 1;                  ///< moves after which it assumes a stop
  double cycle = 0.0;                          ///< of its planner, s
  double least_cycles = 0.0;                   ///< that a move takes at least
  double gap_cycles = 0.0;                     ///< Arc: a line between two arcs that takes less is planned as a part of the second
  double arc_tangential = 1.0;                 ///< Arc: share of the acceleration that is left along it
  double arc_normal = 1.0;                     ///< Arc: share of the acceleration towards its centre
  double kink = 0.0;                           ///< Arc: none if the axes, in one cycle, need this share of their acceleration at the kink
  double jump_time = 0.0;                      ///< AxisJump: s
  double tolerance = 0.01;                     ///< at corners if neither program nor machine says, mm
};

/** The values of \p kind. */
ControlModel controlModel(ControlKind kind);

/** Those of every kind, in the order of the enumeration. */
std::vector<ControlModel> controlModels();

} // namespace pcl_spiral
