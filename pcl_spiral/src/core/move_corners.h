// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What a control does between two moves.
 */
#pragma once

#include "core/control_move.h"
#include <pcl_spiral/core/control_model.h>

namespace pcl_spiral {

/** The way from one move to the next. */
struct MoveCorner {
  CornerRule rule = CornerRule::Stop;
  double speed = 0.0;            ///< the largest at the corner, per s; Overlap: the slower move may have this speed when the next begins
  double cut = 0.0;              ///< Arc: how much of either move it replaces, mm
  double arc = 0.0;              ///< Arc: its length, mm; 0: the corner is passed without one
  double arc_acceleration = 0.0; ///< along the arc
  double lost_share = 0.0;       ///< of the accelerations of both moves, which the kink takes
};

/** What CornerRule means for these two moves. \p tolerance in mm; 0: a stop, unless the kink needs no arc. */
MoveCorner cornerBetween(const ControlMove& before, const ControlMove& after, const ControlModel& control, const AxisDynamics& axes,
                         double tolerance);

} // namespace pcl_spiral
