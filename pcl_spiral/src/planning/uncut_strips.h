// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Narrow strips of a part beside keep-outs that are left uncut, where no path can be planned with them.
 */
#pragma once

#include <pcl_spiral/planning/part_choice.h>
#include <pcl_spiral/surface/surface.h>

#include <vector>

namespace pcl_spiral {

/** The strips of \p cloud between what is not \p kept, ascending, and the rim of \p surface that are narrower than \p width point
 *  spacings, in the order of their first points. Points that are not on the surface are where their nearest point on it is. */
std::vector<UncutStrip> stripsBeside(const Surface& surface, const pcl::PointCloud<pcl::PointXYZ>& cloud, const pcl::Indices& kept,
                                     double width);

/** Place, width and area of a strip, and the remedy, as a warning. */
Diagnostic stripText(const UncutStrip& strip);

} // namespace pcl_spiral
