// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What was left out of a scan, in words. Private to surface.
 */
#pragma once

#include <pcl_spiral/surface/surface.h>

#include <string>
#include <vector>

namespace pcl_spiral {

/** Surplus points and outliers in \p counts, in full sentences. \p spacing of the surface, mm. */
std::vector<std::string> countWarnings(const SurfaceCounts& counts, double spacing);

} // namespace pcl_spiral
