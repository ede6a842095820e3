// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Waviness of a path from turn to turn.
 */
#pragma once

#include <pcl_spiral/verify/figures.h>
#include <pcl_spiral/verify/impl/cutter_path.h>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** \p deviation: of each contact, NaN where it is not measured. Nothing is measured on a path without
 *  ascending turns, or on a path whose turn stays the same along each pass, such as counted rows. */
TurnWobble turnWobble(const CutterPath& path, const std::vector<float>& deviation);

} // namespace pcl_spiral
