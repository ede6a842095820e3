// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  How far the places of a triangle are from its corners. Private to the library.
 */
#pragma once

#include <Eigen/Core>

namespace pcl_spiral {

/** No place of the triangle is farther from the nearest corner than this: the radius of the circle through the corners; if one angle is
 *  90 degrees or more, half of the longest side. */
double coveringRadiusOf(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

} // namespace pcl_spiral
