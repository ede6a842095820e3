// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Where outlines come too near each other for a path between them.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/features/boundary_loop.h>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** Refuses \p outlines[of], with the place, if the strip of surface between it and another outline is narrower than eight of the
 *  \p spacing of the points, mm. */
Status refuseNarrowStrip(const std::vector<BoundaryLoop>& outlines, std::size_t of, double spacing);

} // namespace pcl_spiral
