// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Exact parts with every kind of outline, on flat and on slightly curved surfaces. Lengths in mm.
 */
#pragma once

#include "support/surfaces.h"

#include <cstdint>
#include <string>
#include <vector>

namespace pcl_spiral::test {

/** Names of the outlines for outlinedPart. */
std::vector<std::string> outlineNames();

/** The part of that name; throws std::out_of_range if there is none.
 *
 *  Twenty to fifty passes of a ball of radius 5 that leaves 0.1 fit between rim and middle. \p variation 0:
 * no variation. Otherwise that seed varies size, proportions, position, bends of the sides and waves of the surface;
 * the proportions of disc, square, ellipses and strip do not change. \p size: of the outline and of the surface's
 * waves.
 */
SurfacePtr outlinedPart(const std::string& name, std::uint64_t variation = 0, double size = 1.0);

} // namespace pcl_spiral::test
