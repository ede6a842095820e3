// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Groups of outliers that stand on the surface. Private.
 */
#pragma once

#include <pcl_spiral/cleaning/standing_cluster.h>
#include <pcl_spiral/common/status.h>
#include <pcl_spiral/graph/impl/surface_graph.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

constexpr double far_over_noise = 12.0; ///< times the noise: no point of the surface is farther from it; two of a cluster are
constexpr double unseen = 2.0;          ///< spacings from the nearest point of the surface: there it was not seen

/** Heights of points over a surface, and what can be seen from them. */
struct StandingPoints {
  std::vector<StandingCluster> clusters; ///< the highest first; their indices are among the points given
  double median_height = 0.0;            ///< of all points over the surface, without sign
  double largest_height = 0.0;           ///< without sign
};

/** Which of \p points, outliers and spike candidates of \p graph, stand off its surface together.
 *
 *  A point stands off the surface if its height over the surface of its neighbours, on the outer side, is more than eight times
 *  the noise, theirs and the usual one, and 0.3 of the spacing, and it is not beyond the rim by more than a spacing.
 *  Two or more points of a cluster are higher than twelve times the noise.
 *  Steps of two spacings link the points of a cluster. Points that stand farther apart are linked by steps of six spacings. False echoes
 *  that fly about at random meet by chance: how often is estimated from their distances (leastCluster), for the second links from their
 *  number on the whole surface (leastSpread). Groups of a size that is
 *  expected 0.3 times or more are no clusters. Points within six spacings of a cluster join it, or, where its own points lie far apart,
 *  within three times their mean distance from the nearest one; also those beyond the rim or over a hole, as the middle of a clamp that
 *  hides the surface: alone these are no reason for a cluster. The surface is that of
 *  spikeOutliers, fitted to the points of the graph that are no candidates. */
StandingPoints standingPoints(const SurfaceGraph& graph, const std::vector<Eigen::Vector3f>& points);

/** The box about the points of \p cluster. */
Eigen::AlignedBox3d boxOf(const StandingCluster& cluster);

/** "9 clusters of points stand off the surface: 6 points at (1, 2, 3), 10 mm across and 5.4 mm high, from (-3, 0, 2) to (5, 4, 3), ...
 *  and 5 more". The extents are wider by the \p spacing of the scan, mm: a thing ends between its last point and the next one. */
Diagnostic clustersText(const std::vector<StandingCluster>& clusters, double spacing);

/** Whether a cluster is one point wide, in a scan of this \p spacing: an edge that has too few points, or a wire. Eight points or more,
 *  nine in ten of them with all others within three spacings no more than 0.75 spacings beside one line. */
bool isLine(const StandingCluster& cluster, double spacing);

/** Refuses a scan of this \p spacing, mm, with \p clusters, with what can be done about them. */
Status refusalOf(const std::vector<StandingCluster>& clusters, double spacing);

/** Refuses to ride over \p clusters that hide the surface and are higher than half the \p radius of the ball. Of such a thing only the top
 *  is seen. A ball of radius R that touches the top at a height h stays clear of a straight side below it that leans from the normal by an
 *  angle a towards the ball if h <= R (1 - sin a): half the radius allows for 30 degrees. */
Status checkRideHeight(const std::vector<StandingCluster>& clusters, double radius);

} // namespace pcl_spiral
