// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What was left out of a scan, in words. Private to surface.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/surface/surface.h>

namespace pcl_spiral {

/** Surplus points and outliers in \p counts, in full sentences. \p spacing of the surface, mm. */
Diagnostics countWarnings(const SurfaceReport& counts, double spacing);

} // namespace pcl_spiral
