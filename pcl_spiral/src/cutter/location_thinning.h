// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Leaves out locations that a straight move does not need.
 */
#pragma once

#include <pcl_spiral/core/impl/swept_error.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Marks the \p places to keep: the ends, those marked in \p needed, and as few others as possible. Every point of the
 *  cutter up to \p reach from the tip stays within \p tolerance of its position. \p largest is raised to the
 *  largest such distance. */
std::vector<std::uint8_t> keptPlaces(const std::vector<CutterPlace>& places, const std::vector<std::uint8_t>& needed, double reach,
                                     double tolerance, double& largest);

} // namespace pcl_spiral
