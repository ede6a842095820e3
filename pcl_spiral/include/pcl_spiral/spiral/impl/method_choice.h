/** \file
 *  Which method takes less machine time on a surface, foreseen.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/features/boundary_loop.h>
#include <pcl_spiral/surface/surface.h>
#include <pcl_spiral/spiral/spiral_settings.h>

#include <string>
#include <vector>

namespace pcl_spiral {

/** The method that \p settings ask for: in place of Shortest Radial where a setting has a meaning there alone: a centre, a way
 *  to find lines, the pitch along them. */
SpiralMethod
methodAsked(const SpiralSettings& settings);

/** What each method would come to, foreseen from outlines and step-overs alone. Lengths in mm, times in s. */
struct MethodForesight {
  double radial_length = 0.0, radial_time = 0.0; ///< 0: Radial is not fit for this surface
  double scallop_length = 0.0, scallop_time = 0.0;
  SpiralMethod method = SpiralMethod::ConstantScallop; ///< the one to take
  std::string why_not_radial;                          ///< where it is not fit
};

/** Foresee both methods on \p surface between \p loops (Outer, and Inner for holes).
 *
 *  ConstantScallop: area over the largest step-over, and 0.6 of the rims. Radial: turns are shares of
 *  lines from the centre (or the hole) to the rim. A line that meets the rim at the angle psi off its normal and is d long asks
 *  for d cos(psi) / step-over turns; the most of any line is the number for all, so the length is the area's times the largest
 *  of d cos(psi) over its mean along the rim. sin(psi) is the change of d along the rim. Radial is not fit for several holes, nor
 *  for outlines with corners, at which it leaves higher ridges. A sharp turn at feed v is taken at the speed sqrt(a r) and
 *  costs (v - sqrt(a r))^2 / (a v). Lengths were within 3 % on discs, ovals and rings; where both methods are foreseen alike
 *  within 2 % Radial is taken; within 10 % where turns lie closer than a quarter of the spacing of the points.
 *
 *  Of large surfaces 20,000 points are looked at: the time is that of these. */
MethodForesight
foreseeMethods(const Surface& surface, const std::vector<BoundaryLoop>& loops, const SpiralSettings& settings);

} // namespace pcl_spiral
