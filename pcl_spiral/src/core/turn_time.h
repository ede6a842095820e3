// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The time of turns on a machine that is not known.
 */
#pragma once

namespace pcl_spiral {

/** A path in the plane as a control with three axes takes it. mm and s */
struct TurnPace {
  double feed = 0.0;         ///< mm/s
  double acceleration = 0.0; ///< of each axis, mm/s2
  double chord_error = 0.0;  ///< of its blocks, which is the tolerance at corners, too, mm
  double longest = 0.0;      ///< block, mm
};

/** Time per mm on a circle of \p radius, far from its ends, on LinuxCNC. */
double roundTime(const TurnPace& pace, double radius);

/** Time that a bend by a right angle with \p radius between circles of \p round costs beyond that of its length there. */
double bendTime(const TurnPace& pace, double radius, double round);

} // namespace pcl_spiral
