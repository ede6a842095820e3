// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The most likely edge of points along a smooth line. Private to features.
 */
#pragma once

#include <pcl_spiral/core/polyline.h>

#include <Eigen/Core>

#include <vector>

namespace pcl_spiral {

/** A smooth stretch of an outline between two corners, or a whole outline without corners (closed). */
struct EdgeSide {
  Polyline nodes;                       ///< evenly spaced
  std::vector<Eigen::Vector3d> normals; ///< of the surface at the nodes
  std::vector<Eigen::Vector3d> outward; ///< unit, tangent to the surface, across the side, at the nodes
  bool closed = false;

  std::size_t segments() const { return closed ? nodes.size() : nodes.size() - 1; }
};

/** A point near a side. */
struct SidePoint {
  double place = 0.0;  ///< along the side, in nodes; may lie somewhat beyond the ends
  double offset = 0.0; ///< outward from the side, in spacings
};

/** How an edge is fitted. Lengths in spacings. */
struct EdgeOptions {
  double spacing = 1.0;     ///< mm
  double blur = 0.1;        ///< standard deviation of the points across the edge
  double wavelength = 30.0; ///< shorter waves count as the jaggedness of sampling
};

/** Offsets of a side's nodes, and their costs. */
struct EdgeFit {
  std::vector<double> offsets; ///< outward, in spacings
  double area = 0.0;           ///< between the side and the edge, squared spacings, positive outward
  double outside = 0.0;        ///< cost of the points near or outside the edge
  double roughness = 0.0;      ///< cost of the edge's shape

  double cost() const { return area + outside + roughness; } ///< negative logarithm of the likelihood
};

/** The edge, as offsets of a side's nodes.
 *
 *  Points are modelled as a Poisson process of one point per squared spacing inside the edge and none outside, blurred. The
 *  edge is drawn in by its length, and held out by each point it would leave outside. The rate of change of geodesic
 *  curvature along the side is penalised. The problem is convex.
 */
EdgeFit fitEdge(const EdgeSide& side, const std::vector<SidePoint>& points, const EdgeOptions& options);

} // namespace pcl_spiral
