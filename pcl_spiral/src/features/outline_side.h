/** \file
 *  One smooth side of an outline, fitted to the outermost points. Private to features.
 */
#pragma once

#include <pcl_spiral/core/polyline.h>

#include <Eigen/Core>

#include <vector>

namespace pcl_spiral {

/** A smooth stretch of an outline between two corners, or a whole outline without corners (closed). */
struct OutlineSide {
  Polyline nodes;                       ///< evenly spaced
  std::vector<Eigen::Vector3d> outward; ///< unit, tangent to the surface, across the side, at the nodes
  bool closed = false;
};

/** A point near a side. */
struct SidePoint {
  double place = 0.0;  ///< along the side, in nodes; may lie somewhat beyond the ends
  double offset = 0.0; ///< outward from the side, in spacings
};

/** How a side is fitted. Lengths in spacings. */
struct SideFit {
  double step = 0.5;       ///< between nodes
  double blur = 0.1;       ///< of the edge: how far points scatter across it
  double wavelength = 40;  ///< shorter waves are taken for the jaggedness of sampling
};

/** Offsets of the nodes, outward, in spacings, that make the side the most likely edge of the points.
 *
 *  Points are taken for a Poisson process of one point per squared spacing inside the edge, none outside, blurred; so the
 *  edge is drawn in by its length, and held out by each point it would leave outside. The rate of change of geodesic
 *  curvature along the side is penalised. The problem is convex.
 */
std::vector<double>
fitOffsets(const OutlineSide& side, double spacing, const std::vector<SidePoint>& points, const SideFit& fit);

} // namespace pcl_spiral
