// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Groups of connected points.
 */
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** The group of each point, numbered from 0 in the order of their first points. Steps of no more than \p reach link the points
 *  of a group. */
std::vector<std::uint32_t> pointGroups(const std::vector<Eigen::Vector3f>& points, double reach);

} // namespace pcl_spiral
