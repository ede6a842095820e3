// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  An outline while it is fitted: corners, and a side from every corner to the next. Private to features.
 */
#pragma once

#include "edge_points.h"
#include "side_fit.h"

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** Where two sides meet. */
struct Corner {
  std::size_t point; ///< of the ring, nearest
  double turn;       ///< radians, positive is convex
  Eigen::Vector3d position;
  std::size_t cut_before = 0, cut_after = 0; ///< nodes past the corner on the sides before and after it
  bool sure = false;                         ///< not to be checked again
};

/** Sides fitted to the points near a ring, from corner to corner. */
class OutlineDraft {
public:
  /** Corners where the ring itself seems to turn, if any; no sides yet. */
  OutlineDraft(const MlsSurface& surface, const Ring& ring);

  /** First fit of every side. */
  void fitSides();
  /** With the corners known, assign the points again and fit again from corner to corner. */
  void refine();
  /** Remove the corners: one closed side. */
  void fitClosed();

  /** One smooth side through corner \p c instead of the two that meet there. */
  FittedSide merged(std::size_t c) const;
  /** Replace corner \p c, and the sides that meet there, by \p through. */
  void merge(std::size_t c, FittedSide through);
  /** Put a corner of the given turn at \p node of side \p s and fit a side before and after it; the corner's number is s + 1. */
  void split(std::size_t s, std::size_t node, double turn);
  /** The side from corner \p c to the next, cut off or extended at both ends. */
  EdgeSide trimmed(std::size_t c) const;

  std::size_t following(std::size_t c) const { return (c + 1) % corners.size(); }
  std::size_t preceding(std::size_t c) const { return (c + corners.size() - 1) % corners.size(); }
  const MlsSurface& surface() const { return surface_; }
  double spacing() const { return spacing_; }
  /** Points near the ring. */
  const std::vector<EdgePoint>& edge() const { return edge_; }
  /** The ring, from its first point on. */
  const Polyline& points() const { return points_; }

  std::vector<Corner> corners;
  std::vector<FittedSide> sides; ///< from the corner of the same number to the next; one, closed, without corners

private:
  Polyline pointsBetween(std::size_t from, std::size_t to) const;
  double ringBetween(std::size_t from, std::size_t to) const;
  std::vector<ExpectedPoint> edgeFrom(std::size_t from) const;
  std::vector<ExpectedPoint> edgeBetween(std::size_t from, std::size_t to, double beyond) const;
  FittedSide firstFit(std::size_t c) const;
  FittedSide fitBetween(std::size_t from, std::size_t to, EdgeSide start) const;
  std::size_t nearestPoint(const Eigen::Vector3d& p, std::size_t about, std::size_t window) const;
  void meetAt(std::size_t c);

  const MlsSurface& surface_;
  double spacing_;
  Polyline points_, normals_;
  std::vector<double> at_; ///< place of each point of the ring
  std::vector<EdgePoint> edge_;
};

} // namespace pcl_spiral
