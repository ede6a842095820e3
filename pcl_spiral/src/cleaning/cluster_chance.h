// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  How large a group of false echoes chance makes.
 */
#pragma once

#include <pcl_spiral/cleaning/standing_cluster.h>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** Number of points from which on one of \p groups, linked by steps of \p reach, is larger than chance makes it: groups of that size are
 *  expected less than 0.3 times. How near echoes are is estimated from the pairs of groups one to three \p reach apart, which are eight
 *  times as many on a plane, and more in space. */
std::size_t leastCluster(const std::vector<StandingCluster>& groups, double reach);

/** The same for groups of \p count points that are spread evenly over \p area. */
std::size_t leastSpread(std::size_t count, double reach, double area);

/** Whether \p count points spread evenly over \p area lie so far apart that less than 0.3 others are expected within \p reach of one. */
bool isRare(std::size_t count, double reach, double area);

} // namespace pcl_spiral
