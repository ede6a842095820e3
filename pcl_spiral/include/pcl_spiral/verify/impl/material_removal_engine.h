// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What a cutter leaves on a scanned surface, and where it gouges.
 */
#pragma once

#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/verify/impl/cutter_path.h>
#include <pcl_spiral/verify/impl/cutter_sweep.h>
#include <pcl_spiral/verify/impl/reference_surface.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl_spiral {

/** What was asked of the path. Lengths in mm. */
struct RemovalSettings {
  double tool_radius = 0.0;    ///< of the ball, or of a ball that leaves the same scallop
  double scallop_height = 0.0; ///< allowed between turns
  double chord_error = 0.005;  ///< allowed between a linear move and the surface curve
  double reach = 0.0; ///< how far above the surface stock is looked for; 0: 20 scallop heights, and at least ten times the scan's noise
};

/** Heights above the surface, one value per place. */
struct StockFigures {
  std::size_t samples = 0;
  std::size_t uncut = 0; ///< samples without anything met within the reach; their height is then the reach
  double p50 = 0.0, p90 = 0.0, p99 = 0.0, p999 = 0.0;
  PlacedValue max;
  PlacedValue first_uncut;
  double share_above = 0.0; ///< of the samples, above RemovalFigures::limit
  double uncutShare() const { return samples ? static_cast<double>(uncut) / static_cast<double>(samples) : 0.0; }
};

/** Figures of a path from what its cutter leaves. Indices are those of path points. */
struct RemovalFigures {
  std::size_t reference_points = 0;
  std::size_t unmeasured = 0; ///< reference points without a fit of the surface
  StockFigures stock;         ///< at the reference points farther than one step-over from the rim
  StockFigures scallop;       ///< at the tops of the ridges next to these points; max also next to every path point and between path points
  StockFigures rim;           ///< at the reference points within one step-over of the rim
  PlacedValue gouge;          ///< deepest, at reference points and along every move; 0 if there is none
  PlacedValue rim_gouge;      ///< the same for moves just outside the outermost points, below the extended surface; not looked for in gaps
  StockFigures crease;        ///< at the reference points within crease_band of a crease of the mesh, above the mesh
                              ///< itself. Not part of the other figures: a ball leaves stock in every hollow crease
  PlacedValue crease_gouge;   ///< the deepest there
  double crease_band = 0.0;   ///< see ReferenceSurface::creaseBand
  double limit = 0.0;         ///< 1.02 scallop heights plus the chord error
  double reach = 0.0;         ///< as used
  double area = 0.0;          ///< mm^2
  double rim_length = 0.0;    ///< mm
  double least_length = 0.0;  ///< mm: no path of this scallop height is much shorter, see leastLength
  double path_length = 0.0;   ///< mm
  double efficiency = 0.0;    ///< eta = least_length / path_length
  double noise = 0.0;         ///< see ReferenceSurface::noise
  double fit_noise = 0.0;     ///< see ReferenceSurface::fitNoise; heights below three times this are not known
  double seconds = 0.0;
  std::vector<std::string> warnings;
};

/** Heights at each point of the reference's graph; NaN where there is none. */
struct RemovalHeights {
  std::vector<float> stock; ///< negative: gouge; the reach where uncut
  std::vector<float> ridge; ///< of the ridge next to the point; only in the main area
};

/** Measures stock and gouge. Stock at x, with the surface normal n, is the smallest t at which x + t n lies
 *  in the swept solid. There is a gouge where x itself lies inside. x is the foot of a reference point on
 *  the local fit of the surface. Ridges are V-shaped, so points miss their tops: from each point the top
 *  is looked for across the feed on the local fit. A gouge is also looked for along each move: the depth
 *  of the cutter below the fits at the contacts of its ends (and between, if a move is longer than twice
 *  the radius of a fit). Every figure includes the noise of the fit; max and gouge include its extremes.
 *
 *  Memory: 30 bytes per reference point plus the reference, and 100 to 130 per path point. Parallel;
 *  the same for any number of threads. Fails on settings out of range, and when \p progress cancels. */
Status measureRemovedMaterial(const ReferenceSurface& reference, const CutterPath& path, const CutterSweep& sweep,
                              const RemovalSettings& settings, const ProgressCallback& progress, RemovalHeights& heights,
                              RemovalFigures& figures);

/** Length that a path of constant scallop height needs at least: the integral of dA over
 *  the largest step-over, which is the one across the smallest curvature, plus half the
 *  rim, where half of the pass lies outside the part. \p steps and \p feet: one per point
 *  of the graph; the step is 0 where there is none. \p area is that of the part, mm^2. */
double leastLength(const ReferenceSurface& reference, const std::vector<float>& steps, const std::vector<Eigen::Vector3f>& feet,
                   double& area);

} // namespace pcl_spiral
