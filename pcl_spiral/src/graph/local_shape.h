// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Normal and extent of one neighbourhood. Private.
 */
#pragma once

#include "search/neighbour_search.h"

#include <pcl_spiral/core/impl/angles.h>

#include <Eigen/Core>

#include <cmath>

namespace pcl_spiral {

/** What one neighbourhood shows about its point. */
struct LocalShape {
  Eigen::Vector3d normal; ///< least principal axis of the neighbours (Hoppe et al. 1992), sign arbitrary
  double radius;          ///< distance to the k-th neighbour
  double height;          ///< of the point over its neighbours' plane, along the normal
  double offset;          ///< of the neighbours' mean from the point along the plane, in radii
};

/** Spacing of k evenly spread points in a disc of this radius. */
inline double
evenSpacing(double radius, int k)
{
  return radius * std::sqrt(pi / k);
}

LocalShape localShape(const Neighbourhood& near);

} // namespace pcl_spiral
