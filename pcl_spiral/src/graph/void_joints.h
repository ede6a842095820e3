// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Surfaces of a cloud that nothing joins but triangles over a void. Private.
 */
#pragma once

#include "unseen_steps.h"

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** One flag per triangle, 1 if it joins two surfaces over a void that is wider than twice \p max_circumradius local spacings; empty if
 *  none does. Stars leave out larger circles (SurfaceGraphOptions::max_circumradius), by the spacing that the neighbourhood of their
 *  point has. At a rim half of such a neighbourhood is empty, at a corner three quarters, and it is 1.4 and 2 times as wide: there a star
 *  reaches over to what stands beside the part, such as a clamp of the same height. Here the spacing is that of the part of the
 *  neighbourhood which the surface fills, told by the \p offsets of the neighbours' means, in radii, as of points spread over a sector of
 *  a disc. Where more than a tenth of the triangles is so wide, lines of the scan are far apart, and none is flagged. */
std::vector<std::uint8_t> voidJoints(const TriangulatedPoints& cloud, const std::vector<float>& offsets, double max_circumradius,
                                     const Triangulation& mesh);

} // namespace pcl_spiral
