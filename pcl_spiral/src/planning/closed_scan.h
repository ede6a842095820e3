// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A scan closed by the ball before it is planned. Private to planning.
 */
#pragma once

#include <pcl_spiral/planning/impl/spiral_planning.h>

#include <functional>

namespace pcl_spiral {

/** How a scan is closed for one try. */
struct ClosingTry {
  double rounding = 0.0; ///< share of the radius by which the closed surface is raised: the path is for a ball as much smaller
  bool turned = false;   ///< in the other sense than asked for
};

/** A scan that was closed, and what it is planned with. */
struct ClosedScan {
  PlanInput input;       ///< with the closed scan, its grid, the axis, a smaller ball, and a modifier that keeps the tool clear of the scan
  double rounding = 0.0; ///< mm
  Diagnostics warnings;  ///< what the ball cannot enter
};

/** Closes the scan of \p given along the tool axis (PlanInput::ball_closing), which is fixed: what comes down that way with an upright
 *  shank no wider than the ball meets nothing. */
Status closeScan(const PlanInput& given, const ClosingTry& how, ClosedScan& closed);

/** Moves the contacts of \p plan, made over a closed scan raised by \p rounding, mm, to where the tool itself touches. */
void moveToScan(double rounding, SpiralPlan& plan);

/** Plans over the scan of \p whole, closed, by \p run, which plans every region of an input and moves it by a rounding, until a try gives a
 *  path that is clear of the scan. SpiralPlan::attempts has those that did not. */
Status planClosed(const PlanInput& whole, const std::function<Status(const PlanInput&, double, SpiralPlan&)>& run, SpiralPlan& plan);

} // namespace pcl_spiral
