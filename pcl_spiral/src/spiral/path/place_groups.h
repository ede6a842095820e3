// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Points that lie together. Private to spiral.
 */
#pragma once

#include <pcl_spiral/core/polyline.h>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** The group of each of \p points, numbered in the order of their first points; \p count: number of groups. Points in cubes of this
 *  \p edge, mm, that are the same or neighbours are one group. */
std::vector<std::size_t> placeGroups(const Polyline& points, double edge, std::size_t& count);

} // namespace pcl_spiral
