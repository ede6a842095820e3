// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Links of rows over a scan. Private.
 */
#pragma once

#include "mesh/row_links.h"
#include <pcl_spiral/surface/surface.h>

namespace pcl_spiral {

/** Places on the fitted surface: over the triangles of \p mesh or within a spacing of them, not in a void. Keeps
 *  references to both arguments. */
PlacesOnSurface onScan(const Surface& surface, const Triangulation& mesh);

} // namespace pcl_spiral
