// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Measures from the neighbours of a point that show whether it lies on the boundary.
 */
#pragma once

#include <Eigen/Core>
#include <pcl_spiral/features/boundary_loop.h>

#include <vector>

namespace pcl_spiral {

/** Two measures of a boundary point, both without unit. */
struct BoundaryEvidence {
  double offset = 0.0; ///< distance from the point to the centroid of its neighbours, over their radius: 0 to 1
  double gap = 0.0;    ///< largest angle without a neighbour, radians: 0 to 2 pi
};

/** Evidence from the neighbours in the tangent plane of a point.
 *
 *  The offset is the lambda of Wu et al. 2025, equation 1, made dimensionless by the radius of the
 *  neighbourhood; on an even cloud it is 0 inside, 4 / (3 pi) = 0.424 on a straight boundary, 0.60 at a corner of
 *  90 degrees, 0.20 at one of 270. The gap is that of pcl::BoundaryEstimation. If all neighbours are at the
 *  place of the point: offset 0, gap 2 pi.
 *  \param offsets of the neighbours from the point, in the tangent plane; those at the point do not count
 *  \param radius of the neighbourhood, above 0
 *  \param angles working memory */
BoundaryEvidence boundaryEvidence(const std::vector<Eigen::Vector2d>& offsets, double radius, std::vector<double>& angles);

/** Decide by a criterion. Thresholds above 0, that of the gap in radians. */
bool isBoundary(const BoundaryEvidence& evidence, BoundaryCriterion criterion, double offset_threshold, double gap_threshold);

} // namespace pcl_spiral
