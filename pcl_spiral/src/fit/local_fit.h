// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  One local fit of the surface. Private.
 */
#pragma once

#include "patch_search.h"

#include "search/neighbour_search.h"
#include <pcl_spiral/fit/impl/mls_surface.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace pcl_spiral {

/** How far a query lies outside the outermost of its neighbours, seen towards their centroid (an offset from it in the
 *  tangent plane); 0 if it lies among them. */
template <typename Points>
double
overhang(const Points& points, const Eigen::Vector3d& centroid)
{
  const double distance = centroid.norm();
  if (!(distance > 0.0))
    return 0.0;
  const Eigen::Vector3f inward = (centroid / distance).template cast<float>();
  float nearest = std::numeric_limits<float>::max();
  for (int j = 0; j < points.size && nearest > 0.0f; ++j)
    nearest = std::min(nearest, points.x[j] * inward.x() + points.y[j] * inward.y() + points.z[j] * inward.z());
  return std::max(0.0f, nearest);
}

/** Mean of the oriented normals of the nearest few points. */
Eigen::Vector3d meanNormal(const std::uint32_t* nearest, int count, const std::vector<Eigen::Vector3f>& normals);

/** Foot of a query on the quadric f(u, v) = b0 + b1 u + b2 v + b3 u^2 + b4 u v + b5 v^2 over the plane across \p up,
 *  fitted to its neighbours with the weight (1 - r^2)^3, r the distance in the plane over that of the farthest.
 *  Source: Levin, The approximation power of moving least squares, 1998; weight after Wendland. */
SurfaceFoot quadraticFoot(const Eigen::Vector3d& query, const Patch& patch, const Eigen::Vector3d& up);

/** Foot on a polynomial of the fourth degree with the same weight, as far as the data show it to differ from the quadric. Neighbours
 *  more than four standard deviations off it (by the median deviation) are left out and the rest is fitted again, up to
 *  ten times. */
SurfaceFoot robustQuarticFoot(const Eigen::Vector3d& query, const Neighbourhood& near, const Eigen::Vector3d& up);

/** Foot by the published directional centroid: along the mean normal onto the plane through the weighted centroid.
 *  Source: Wu et al. 2025, equations (8)-(11), with weights exp(-|p - q|^2 / h^2). */
SurfaceFoot directionalCentroidFoot(const Eigen::Vector3d& query, const Neighbourhood& near, const std::vector<Eigen::Vector3f>& normals);

} // namespace pcl_spiral
