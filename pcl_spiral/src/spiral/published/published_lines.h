// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Radial lines as published. Private to spiral.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/spiral/impl/radial_lines_engine.h>
#include <pcl_spiral/spiral/spiral_settings.h>

#include <cstddef>
#include <functional>
#include <optional>

namespace pcl_spiral {

/** The input of published lines. */
struct PublishedLineRequest {
  const MlsSurface& surface; ///< with ProjectionMethod::DirectionalCentroid: (8)-(11)
  const BoundaryLoop& rim;
  const BoundaryLoop* inner = nullptr;              ///< second boundary, if any
  Eigen::Vector3d centre = Eigen::Vector3d::Zero(); ///< on the surface; one boundary only
  std::optional<Eigen::Vector3d> start_point;       ///< line 0 ends nearest to it; absent: where the rim's points begin
  double chord_error = 0.005;                       ///< mm
  std::function<bool(double)> progress;             ///< share done; false cancels
};

/** Figures about the lines. */
struct PublishedLineReport {
  std::size_t unsettled = 0; ///< geodesics whose last step was still more than the chord error sideways
  double largest_move = 0.0; ///< mm: the most any of them still moved
};

/** Number of lines for which chords between their ends lie within the chord error of a circle as long as the rim;
 *  ends are at least half a spacing apart. */
std::size_t publishedLineCount(double rim_length, double chord_error, double spacing);

/** Lines as Wu et al. 2025 make them, each stage with its equations there:
 *  seeds at equal distances on the rim, and their partners on the inner loop if there is one (matchLoops);
 *  shortest ways over the elliptic Gabriel graph (one tree from the centre; with two boundaries one from each
 *  partner); the conjugate-gradient Newton step on the geodesic curvature, (2)-(7); projection, (8)-(11);
 *  Taubin smoothing with fixed ends; projection again; B-spline; Taubin's curvatures at the cloud's point
 *  nearest to each station, (12).
 *
 *  Corrected where it cannot work as printed: the Newton step keeps the ends fixed, and goes from coarse to fine
 *  (refineGeodesics); lines have levels, by which turns leave most of them out near the centre. Feet have the
 *  curvatures of (12); normals and positions are those of the projection. If the graph does not lead to the rim,
 *  or if a line leaves the surface, it fails and names the place. Crossing lines are not searched for
 *  here. */
Status publishedLines(const PublishedLineRequest& request, RadialLineSet& set, PublishedLineReport& figures);

} // namespace pcl_spiral
