// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Whether an organised cloud was seen from the origin of its coordinates. Private.
 */
#pragma once

#include "point_table.h"

#include <cstddef>

namespace pcl_spiral {

/** True if the points of \p table, in rows of \p width, may be the image of a camera or scanner at the origin:
 *  - the origin is outside of them: all lie within 60 degrees of their mean direction;
 *  - it does not lie in the surface: half of the surface is at least a fifth of the diagonal of the points away from it, measured along
 *    its normal. A flat part that fills a field of view of 136 degrees from corner to corner is as near;
 *  - it sees one side: the image is not folded on nine tenths of the area, as of any view point.
 *
 *  Height maps over a grid about z = 0 fail: their origin lies in the surface or beside it. */
bool seenFromOrigin(const PointTable& table, std::size_t width);

} // namespace pcl_spiral
