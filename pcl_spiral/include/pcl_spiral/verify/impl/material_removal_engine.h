// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What a cutter leaves on a scanned surface, and where it gouges.
 */
#pragma once

#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/verify/figures.h>
#include <pcl_spiral/verify/impl/cutter_path.h>
#include <pcl_spiral/verify/impl/cutter_sweep.h>
#include <pcl_spiral/verify/impl/reference_surface.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace pcl_spiral {

/** What was asked of the path. Lengths in mm. */
struct RemovalSettings {
  double tool_radius = 0.0;    ///< of the cutter
  double scallop_height = 0.0; ///< allowed between turns
  double chord_error = 0.005;  ///< allowed between a linear move and the surface curve
  double reach = 0.0; ///< how far above the surface stock is looked for; 0: 20 scallop heights, and at least ten times the scan's noise
  double step_radius = 0.0;            ///< of a ball that leaves the same scallop; 0: tool_radius
  std::optional<double> corner_radius; ///< of the ball that must fit into hollows; 0: a sharp edge, which reaches all; absent: tool_radius
};

/** Heights at each point of the reference's graph; NaN where there is none. */
struct RemovalHeights {
  std::vector<float> stock; ///< negative: gouge; the reach where uncut
  std::vector<float> ridge; ///< of the ridge next to the point; only in the main area
};

/** Measures stock and gouge. Stock at x, with the surface normal n, is the smallest t at which x + t n lies
 *  in the swept solid. There is a gouge where x itself lies inside. Its depth is -t. Where the ray may leave
 *  the part, under a rim or through a ridge, or only grazes balls, it is the shortest way out of the cutter
 *  from x. x is the foot of a reference point on the local fit of the surface. Ridges are V-shaped, so points
 *  miss their tops: from each point the top is looked for across the feed on the local fit.
 *  A gouge is also looked for along each move: the depth
 *  of the cutter below the fits at the contacts of its ends (and between, if a move is longer than twice
 *  the radius of a fit). Every figure includes the noise of the fit; max and gouge include its extremes.
 *
 *  Memory: 30 bytes per reference point plus the reference, and 100 to 130 per path point. Parallel;
 *  the same for any number of threads. Fails on settings out of range, and when \p progress cancels. */
Status measureRemovedMaterial(const ReferenceSurface& reference, const CutterPath& path, const CutterSweep& sweep,
                              const RemovalSettings& settings, const ProgressCallback& progress, RemovalHeights& heights,
                              RemovalReport& figures);

/** Length that a path of constant scallop height needs at least: the integral of dA over
 *  the largest step-over, which is the one across the smallest curvature, plus half of \p rim_share of the
 *  rim, where half of the pass lies outside the part. \p steps and \p feet: one per point
 *  of the graph; the step is 0 where there is none. \p area is that of the part with steps and of that share of its rim, mm^2. */
double leastLength(const ReferenceSurface& reference, const std::vector<float>& steps, const std::vector<Eigen::Vector3f>& feet,
                   double rim_share, double& area);

} // namespace pcl_spiral
