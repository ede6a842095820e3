/** \file
 *  What a cutter leaves on a scanned surface and what it takes too much.
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
  double tool_radius = 0.0;    ///< of the ball, or of the one that leaves the same scallop
  double scallop_height = 0.0; ///< allowed between turns
  double chord_error = 0.005;  ///< allowed between a linear move and the surface curve
  double reach = 0.0; ///< stock looked for above the surface; 0: 20 scallop heights, and ten times the scan's noise
};

/** Heights above the surface, one value a place. */
struct StockFigures {
  std::size_t samples = 0;
  std::size_t uncut = 0; ///< of the samples: nothing is met within the reach, which is then their height
  double p50 = 0.0, p90 = 0.0, p99 = 0.0, p999 = 0.0;
  PlacedValue max;
  PlacedValue first_uncut;
  double share_above = 0.0; ///< of the samples, above RemovalFigures::limit
  double uncutShare() const { return samples ? static_cast<double>(uncut) / static_cast<double>(samples) : 0.0; }
};

/** Figures of a path by what its cutter leaves. Indices are those of path points. */
struct RemovalFigures {
  std::size_t reference_points = 0;
  std::size_t unmeasured = 0; ///< of them, without a fit of the surface
  StockFigures stock;   ///< at the reference points, farther than one step-over from the rim
  StockFigures scallop; ///< at the tops of the ridges next to them; max also beside every path point and between them
  StockFigures rim;     ///< at the reference points within one step-over of the rim
  PlacedValue gouge;    ///< deepest, at reference points and along every move; 0 when there is none
  PlacedValue rim_gouge; ///< the same of moves just outside the outermost points, below the surface carried on; in gaps of the scan none is sought
  StockFigures crease;  ///< at the reference points within crease_band of a crease of the mesh, over the mesh itself: no part of the
                        ///< other figures, for a ball leaves stock in every hollow crease
  PlacedValue crease_gouge; ///< the deepest there
  double crease_band = 0.0; ///< ReferenceSurface::creaseBand
  double limit = 0.0;   ///< 1.02 scallop heights and the chord error
  double reach = 0.0;   ///< as used
  double area = 0.0;         ///< mm^2
  double rim_length = 0.0;   ///< mm
  double least_length = 0.0; ///< mm: no path of this scallop height is much shorter, see leastLength
  double path_length = 0.0;  ///< mm
  double efficiency = 0.0;   ///< eta = least_length / path_length
  double noise = 0.0;     ///< ReferenceSurface::noise
  double fit_noise = 0.0; ///< ReferenceSurface::fitNoise: heights below three times this are not known
  double seconds = 0.0;
  std::vector<std::string> warnings;
};

/** Heights at each point of the reference's graph, NaN where there is none. */
struct RemovalHeights {
  std::vector<float> stock; ///< negative: gouge; the reach where uncut
  std::vector<float> ridge; ///< of the ridge next to the point; main area alone
};

/** Stock over x, with n the surface's normal, is the smallest t at which x + t n lies in the swept solid; a
 * gouge is where x itself lies inside. x is the foot of a reference point on the local fit of the surface.
 * Ridges are V-shaped, so points miss their tops: from each point the top is sought across the feed on the
 * local fit. A gouge is also sought along each move, as the depth of the cutter below the fits at the
 * contacts of its ends (and between, where a move is longer than twice the radius of a fit). Every figure
 * carries the noise of the fit; max and gouge carry its extremes.
 *
 *  Memory: 30 bytes a reference point beside the reference, and 100 to 130 a path point. Parallel, the same for any
 * number of threads. Fails on settings out of range and when \p progress cancels. */
Status
measureRemovedMaterial(const ReferenceSurface& reference, const CutterPath& path, const CutterSweep& sweep,
                       const RemovalSettings& settings, const ProgressCallback& progress, RemovalHeights& heights,
                       RemovalFigures& figures);

/** Length that a path of constant scallop cannot do without: the integral of dA over the largest step-over,
 * which is the one across the smallest curvature, and half the rim, where half of the pass lies beside the
 * part. \p steps and \p feet: one a point of the graph, the step 0 where there is none; \p area is the
 * part's, mm^2. */
double
leastLength(const ReferenceSurface& reference, const std::vector<float>& steps,
            const std::vector<Eigen::Vector3f>& feet, double& area);

} // namespace pcl_spiral
