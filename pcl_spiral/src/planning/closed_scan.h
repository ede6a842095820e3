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
  ClosingReport figures; ///< of the closing
  Diagnostics warnings;  ///< what the ball cannot enter
};

/** InvalidArgument for an input with which planClosed does nothing: a mesh, keep-outs, and settings that do not go with a closed scan. */
Status checkClosable(const PlanInput& input);

/** Closes the scan of \p given along the tool axis (PlanInput::ball_closing), which is fixed: what comes down that way with an upright
 *  shank no wider than the ball meets nothing. Of \p seen it keeps the part that was chosen. */
Status closeScan(const PlanInput& given, const SeenParts& seen, const ClosingTry& how, ClosedScan& closed);

/** Moves the contacts of \p plan, made over a closed scan raised by \p rounding, mm, to where the tool itself touches. */
void moveToScan(double rounding, SpiralPlan& plan);

/** Plans every region of an input over a surface that is raised by a length, mm. */
using PlanRun = std::function<Status(const PlanInput&, double, SpiralPlan&)>;

constexpr std::size_t closing_tries = 5;             ///< roundings, senses and methods that planClosed has
constexpr std::size_t closing_tries_of_a_change = 2; ///< that are made to learn whether the closing gives a path: most paths are by these

/** Plans over the scan of \p whole, closed in the first \p most of the ways, by \p run, until one gives a path that is clear of the scan.
 *  SpiralPlan::attempts has those that did not. */
Status planClosed(const PlanInput& whole, std::size_t most, const PlanRun& run, SpiralPlan& plan);

/** Whether somebody said from which side the scan of \p input was taken, or the tool comes. */
bool knowsSide(const PlanInput& input);

} // namespace pcl_spiral
