// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Predicts which method takes less machine time on a surface.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/features/boundary_loop.h>
#include <pcl_spiral/spiral/spiral_settings.h>
#include <pcl_spiral/surface/surface.h>

#include <vector>

namespace pcl_spiral {

/** The method that \p settings select. Shortest becomes Radial if a setting has an effect only there: a centre, a way
 *  to find lines, the pitch along them. */
SpiralMethod methodAsked(const SpiralSettings& settings);

/** Prediction for each method, from outlines and step-overs only. Lengths in mm, times in s. */
struct MethodForesight {
  double radial_length = 0.0, radial_time = 0.0; ///< 0: Radial is not suitable for this surface
  double scallop_length = 0.0, scallop_time = 0.0;
  SpiralMethod method = SpiralMethod::ConstantScallop; ///< the better one
  Diagnostic why_not_radial;                           ///< if it is not suitable
  bool radial_fails = false;                           ///< it is not suitable, and makes no path at all
};

/** Predict both methods on \p surface between \p loops (Outer, and Inner for holes).
 *
 *  ConstantScallop: area over the largest step-over, and 0.6 of the boundary length. Radial: turns are shares of lines from the centre
 *  (or the hole) to the rim. A line of length d that meets the rim at the angle psi from its normal needs d cos(psi) / step-over
 *  turns. The line with the most turns sets the number for all. So the length is that of the area times the ratio of the largest
 *  d cos(psi) to its mean along the rim. sin(psi) is the change of d along the rim. Radial is not suitable for several holes or
 *  for outlines with corners, where it leaves higher ridges. Times are those of a three-axis machine with this acceleration on LinuxCNC
 *  (turn_time.h): per length on a circle half as long as the rims, and for each sharp turn what a bend by a right angle with a quarter of
 *  a step-over as radius costs. Predicted lengths were within 3 % on discs, ovals and annuli. If both predictions agree within 2 %,
 *  Radial is taken; within 10 % if turns lie closer than a quarter of the spacing of the points.
 *
 *  On large surfaces it looks at only 20,000 points, and its running time is that of these. */
MethodForesight foreseeMethods(const Surface& surface, const std::vector<BoundaryLoop>& loops, const SpiralSettings& settings);

} // namespace pcl_spiral
