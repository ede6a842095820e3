// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A side of an outline along the edge of its points. Private to features.
 */
#pragma once

#include "edge_fit.h"

#include <pcl_spiral/fit/impl/mls_surface.h>

#include <vector>

namespace pcl_spiral {

/** Distance between the nodes of a side, in spacings. */
constexpr double node_step = 0.5;
/** Of one wave more in the length of a side, in units of EdgeFit::cost. */
constexpr double freedom_cost = 6.0;

/** A side at the edge of its points. */
struct FittedSide {
  EdgeSide side;
  double outside = 0.0, roughness = 0.0; ///< as in EdgeFit; outside is infinite where no smooth side fits
  double wavelength = 0.0;
};

/** Foot of a point on a side. */
struct SideFoot {
  double place = 0.0;  ///< in nodes; beyond the ends of an open side as far as the point is
  double offset = 0.0; ///< outward, mm
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
};

/** Foot of \p point on \p side, searched among the nodes within \p reach of node \p expected. */
SideFoot footOn(const EdgeSide& side, const Eigen::Vector3d& point, std::ptrdiff_t expected, std::ptrdiff_t reach);

/** Replace the nodes by evenly spaced ones, keeping the ends; then set the outward directions. */
void makeEven(EdgeSide& side, double spacing);

/** An evenly spaced line through a jagged one, without waves shorter than a few spacings. */
EdgeSide smoothSide(const Polyline& line, bool closed, double spacing);

/** Move the nodes onto the surface where it is known there, and take its normals. */
void layOnSurface(const MlsSurface& surface, EdgeSide& side);

/** A point of an edge, and where along the side it is expected, as a share of its length. */
struct ExpectedPoint {
  Eigen::Vector3d position;
  double share;
};

/** Fit a side to the edge of \p points, starting from \p start, along \p ring (mm) of the points round the edge. A side that grows to a
 *  multiple of that is no fit: its \p outside is infinite. */
FittedSide fitSide(const MlsSurface& surface, double spacing, EdgeSide start, std::vector<ExpectedPoint> points, double ring);

} // namespace pcl_spiral
