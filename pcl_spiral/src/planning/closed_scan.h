// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A scan closed by the ball before it is planned. Private to planning.
 */
#pragma once

#include "planning/seen_parts.h"
#include <pcl_spiral/cleaning/ball_closing.h>
#include <pcl_spiral/planning/impl/spiral_planning.h>

#include <functional>

namespace pcl_spiral {

/** How a scan is closed for one try. */
struct ClosingTry {
  double rounding = 0.0; ///< share of the radius by which the closed surface is raised: the path is for a ball as much smaller
  bool turned = false;   ///< in the other sense than asked for
  bool radial = false;   ///< with radial lines if no method is asked for; else at constant scallop
};

/** A scan that was closed, and what it is planned with. */
struct ClosedScan {
  PlanInput input;       ///< with the closed scan, its grid, the axis, a smaller ball, and a modifier that keeps the tool clear of the scan
  double rounding = 0.0; ///< mm
  ClosingFigures figures; ///< of the closing
  Diagnostics warnings;   ///< what the ball cannot enter
};

/** Closes the scan of \p given along the tool axis (PlanInput::ball_closing), which is fixed: what comes down that way with an upright
 *  shank no wider than the ball meets nothing. Of \p seen it keeps the part that was chosen. */
Status closeScan(const PlanInput& given, const SeenParts& seen, const ClosingTry& how, ClosedScan& closed);

/** Moves the contacts of \p plan, made over a closed scan raised by \p rounding, mm, to where the tool itself touches. */
void moveToScan(double rounding, SpiralPlan& plan);

/** Plans every region of an input over a surface that is raised by a length, mm. */
using PlanRun = std::function<Status(const PlanInput&, double, SpiralPlan&)>;

/** Plans over the scan of \p whole, closed, by \p run, until a try gives a path that is clear of the scan. SpiralPlan::attempts has those
 *  that did not. */
Status planClosed(const PlanInput& whole, const PlanRun& run, SpiralPlan& plan);

/** What to add to the refusal of \p whole: whether closed by the ball, which is tried, it gives a path. Empty if not, or if nobody said
 *  from which side the scan was taken or the tool comes. */
Diagnostic closingRemedy(const PlanInput& whole, const PlanRun& run);

} // namespace pcl_spiral
