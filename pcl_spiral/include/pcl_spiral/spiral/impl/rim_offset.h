// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Moves outlines off the rim and holes of a surface.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/features/boundary_loop.h>
#include <pcl_spiral/surface/surface.h>

#include <vector>

namespace pcl_spiral {

/** Move the outlines among \p loops: the outer one by \p overhang mm, above 0 beyond the rim and below 0 inside it; those of holes
 *  by \p hole_margin mm, 0 or more, away from the hole. Distances are measured along the surface. Other loops stay.
 *
 *  Inside, outlines are level lines of the distance from the boundaries: corners stay sharp, and outlines that meet become one. Beyond
 *  the rim, rows of points continue the surface straight (Surface::isGuessed). A surface with these points replaces \p surface, and
 *  corners of the part are rounded with the overhang as radius. Fails, and changes nothing, if the surface falls into pieces or
 *  nothing is left of it. */
Status offsetOutlines(Surface::ConstPtr& surface, std::vector<BoundaryLoop>& loops, double overhang, double hole_margin);

} // namespace pcl_spiral
