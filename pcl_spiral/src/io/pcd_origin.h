// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The comment of a .pcd with the place that its float coordinates are relative to.
 */
#pragma once

namespace pcl_spiral {

/** Begins the line; three numbers in mm follow. */
constexpr const char* pcd_origin_mark = "# origin, mm, to be added to x y z: ";

} // namespace pcl_spiral
