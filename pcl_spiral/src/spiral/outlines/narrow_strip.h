// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Where outlines come too near each other for a path between them, and what to do at places without one.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/features/boundary_loop.h>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** Refuses \p outlines[of], with the place, if the strip of surface between it and another outline is narrower than eight of the
 *  \p spacing of the points, mm. */
Status refuseNarrowStrip(const std::vector<BoundaryLoop>& outlines, std::size_t of, double spacing);

/** "keep the cutter out of what stands there with a polygon that covers it, from (1, 2, 3) to (4, 5, 6) (addKeepOut), or " for \p places
 *  and one \p spacing round them, mm, if there are any; else nothing: a part of a message. */
Diagnostic keepOutText(const Polyline& places, double spacing);

} // namespace pcl_spiral
