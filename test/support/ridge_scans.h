// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Full scans of exact ridges.
 */
#pragma once

#include "support/ridges.h"

#include <cstdint>
#include <vector>

namespace pcl_spiral::test {

/** One random point in each cell of \p along by \p across, each coordinate moved by Gaussian noise. */
std::vector<Eigen::Vector3d> scanOf(const ExactRidge& ridge, int along, int across, double noise, std::uint64_t seed);

/** Rough points of the die ridge: alternately 3 mm to one side of its crest and 3 mm to the other, so that lines between them are at 10
 *  degrees and more to it. */
std::vector<Eigen::Vector3d> roughPointsOfDie(const ExactRidge& die);

} // namespace pcl_spiral::test
