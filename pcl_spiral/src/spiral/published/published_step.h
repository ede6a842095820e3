// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The one step of the published path. Private to spiral.
 */
#pragma once

#include <pcl_spiral/spiral/radial_line.h>

#include <vector>

namespace pcl_spiral {

/** Distance of points along the path, mm, the same everywhere: Wu et al. 2025, equations (13)-(15), 2 sqrt(2
 *  rho e - e^2). Here rho is the smallest radius of curvature, hollow or not, at any station of any line, and e
 *  the \p chord_error; at most \p largest_step. Their D is the radius of the section here. */
double publishedStep(const std::vector<RadialLine>& lines, double chord_error, double largest_step);

} // namespace pcl_spiral
