// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Distance along a surface from a point or a closed curve, and the path back.
 */
#pragma once

#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/graph/impl/surface_graph.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace pcl_spiral {

/** Geodesic distance from a source at every point of a graph, in mm.
 *
 *  Fast marching over the triangles (Kimmel, Sethian 1998) with circular fronts (virtual sources; Novotni, Klein
 *  2002) and label correction, so that obtuse triangles are corrected by their late corners. Near the source the
 *  distances are straight lines corrected for curvature. The graph must outlive the field. Deterministic.
 */
class DistanceField {
public:
  static constexpr double unreached = std::numeric_limits<double>::infinity();

  /** Distances from a point. False, with nothing reached, if it is farther than three spacings from the cloud. */
  bool compute(const SurfaceGraph& graph, const Eigen::Vector3d& source);

  /** Distances to the nearest point of a closed curve on the surface, on either side. False as above. */
  bool compute(const SurfaceGraph& graph, const Polyline& closed_source_curve);

  std::size_t size() const { return distances_.size(); }
  /** Distance at point \p i of the graph; unreached if no triangles lead there. */
  double distance(std::size_t i) const { return distances_[i]; }
  const std::vector<double>& distances() const { return distances_; }
  /** Distance at any position near the surface, from the points near it. */
  double distanceAt(const Eigen::Vector3d& position) const;
  /** Unit, tangent, away from the source; zero at the source itself and at unreached points. */
  Eigen::Vector3d gradient(std::size_t i) const { return gradients_[i].cast<double>(); }

  /** Shortest path from the source to \p to, by steepest descent, in steps of about one spacing. The first point is
   *  the source (or the nearest point of the source curve), the last is \p to. The path always arrives: where the gradient
   *  misleads, it follows the points downhill. Empty if \p to is off the cloud or on a part not reached. */
  Polyline trace(const Eigen::Vector3d& to) const;

private:
  struct Place;
  void prepare(const SurfaceGraph& graph);
  std::uint32_t nearestReached(const Eigen::Vector3d& x) const;
  Eigen::Vector3d smoothGradient(Place& place) const;
  bool step(Place& place) const;
  std::uint32_t lowestNeighbour(std::uint32_t v) const;
  Eigen::Vector3d sourceNearestTo(const Eigen::Vector3d& x) const;

  const SurfaceGraph* graph_ = nullptr;
  Polyline source_; ///< one point, or a closed curve
  std::vector<double> distances_;
  std::vector<Eigen::Vector3f> gradients_;
};

} // namespace pcl_spiral
