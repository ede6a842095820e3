// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Refines rough lines on a surface to geodesics.
 */
#pragma once

#include <pcl_spiral/core/impl/polyline.h>
#include <pcl_spiral/surface/impl/mls_surface.h>

#include <limits>
#include <vector>

namespace pcl_spiral {

/** A curve on a surface between two fixed points, with equal spacing. Lengths in mm. */
struct GeodesicLine {
  Polyline points;               ///< the first and last are kept as given
  std::vector<SurfaceFoot> feet; ///< one per point; at the ends position is the end itself, and valid is true if the
                                 ///< surface reaches it
  double length = 0.0;           ///< of a smooth curve through the points, not of the chords
  double largest_move = std::numeric_limits<double>::infinity(); ///< sideways, required by the last iteration
  bool converged = false;                                        ///< largest_move is within the tolerance
  bool left_surface = false;                                     ///< the geodesic leaves the cloud: over a re-entrant rim or a gap
  Eigen::Vector3d left_at = Eigen::Vector3d::Zero();             ///< the first such place, if left_surface
};

/** The step that brings a line nearer to its geodesic. */
enum class RefinementMethod {
  TridiagonalNewton,      ///< sideways moves from a tridiagonal system with the Gauss curvature
  ConjugateGradientNewton ///< as published (Wu et al. 2025, equations 2-7), with fixed ends; slower
};

struct RefinementOptions {
  std::vector<int> levels{16, 32, 64, 128}; ///< segments of a line, coarse to fine; the last is the result's
  int max_iterations = 30;                  ///< per level
  double tolerance = 0.001;                 ///< mm: largest move at which a line counts as converged
  RefinementMethod method = RefinementMethod::TridiagonalNewton;
  bool probe_normals = true; ///< correct the normals by feet beside the line, at the end: half as much work again
};

/** Turn lines that start from a trace or graph path into geodesics: lines[i].points, at least two each.
 *
 *  All lines are projected together, once per iteration. Every accepted move shortens its line. A line that cannot continue
 *  because the surface ends keeps its last position on the surface, with left_surface set; it is then not
 *  a geodesic. The same bytes for any number of threads.
 */
void refineGeodesics(const MlsSurface& surface, const RefinementOptions& options, std::vector<GeodesicLine>& lines);

} // namespace pcl_spiral
