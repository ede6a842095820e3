// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Parts of every kind of outline, on flat and on gently curved ground, known exactly. Lengths in mm.
 */
#pragma once

#include "support/surfaces.h"

#include <cstdint>
#include <string>
#include <vector>

namespace pcl_spiral::test {

/** Names of the outlines, as outlinedPart knows them. */
std::vector<std::string> outlineNames();

/** The part of that name; throws std::out_of_range when there is none.
 *
 *  Twenty to fifty passes of a ball of radius 5 that leaves 0.1 fit between rim and middle. \p variation 0:
 * as drawn. Any other: size, proportions, position, bends of the sides and the ground's waves by that seed;
 * the proportions of disc, square, ellipses and strip stay. \p size: of the outline and of the ground's
 * waves.
 */
SurfacePtr outlinedPart(const std::string& name, std::uint64_t variation = 0, double size = 1.0);

} // namespace pcl_spiral::test
