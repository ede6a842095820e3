// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Locations that a straight move can do without.
 */
#pragma once

#include <pcl_spiral/core/impl/swept_error.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Which of \p places to keep: the ends, those that \p needed says, and as few others as keep every point of the
 *  cutter, no farther than \p reach from the tip, within \p tolerance of where it was. \p largest is widened to the
 *  largest such distance. */
std::vector<std::uint8_t> keptPlaces(const std::vector<CutterPlace>& places, const std::vector<std::uint8_t>& needed, double reach,
                                     double tolerance, double& largest);

} // namespace pcl_spiral
