// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A front that moves over the triangles of a graph, one after the other.
 */
#pragma once

#include "bucket_queue.h"
#include "front_round.h"

#include <pcl_spiral/graph/impl/surface_graph.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Carries distances known at seeds to all points.
 *
 *  A front about a point is a circle about the source at distance 0. In general the front at a point is approximated by a
 *  circle about a centre at which the distance would be \p centre: above the distance here if the front contracts.
 *
 *  Points settle in rounds, half a spacing of the front at a time. All that settle look in parallel for shorter ways to
 *  their neighbours, before any is taken, so the result does not depend on the threads. A point to which a shorter way is
 *  found later settles again.
 */
class FrontMarch {
public:
  FrontMarch(const SurfaceGraph& graph, std::vector<double>& distances, std::vector<Eigen::Vector3f>& gradients);

  /** A point whose distance, gradient and centre are known. */
  void addSeed(std::uint32_t point, double distance, const Eigen::Vector3d& gradient, double centre);
  void run();

private:
  enum class State : std::uint8_t {
    Far,
    Waiting, ///< its distance has changed, and its neighbours do not know yet
    Settled
  };
  struct Way {
    double distance;
    double centre;
    Eigen::Vector3f step; ///< from the place on an edge, or the point, that it comes from
    std::uint32_t to;
  };
  using Ways = std::vector<Way>;

  bool settled(std::uint32_t v) const { return state_[v] == State::Settled; }
  /** Settle the points of the front that still wait; forget the rest. */
  void settleFront();
  void visit(std::uint32_t v, Ways& ways) const;
  void tryAlong(std::uint32_t v, std::uint32_t j, Ways& ways) const;
  /** The way of a front that crosses the edge a - v, in the plane of the triangle. */
  void tryAcross(std::uint32_t a, std::uint32_t v, std::uint32_t j, Ways& ways) const;
  double commonCentre(std::uint32_t a, std::uint32_t v) const;
  void take(const Way& way);
  /** Turn the last steps into unit tangents. */
  void straightenGradients();

  const SurfaceGraph& graph_;
  const Triangulation& mesh_;
  std::vector<double>& distances_;
  std::vector<Eigen::Vector3f>& gradients_;
  std::vector<double> centres_;
  std::vector<State> state_;
  double least_gain_; ///< mm: smaller improvements are not passed on
  BucketQueue queue_;
  std::vector<std::uint32_t> front_; ///< what settles in this round
  FrontRound<Way> round_;
};

} // namespace pcl_spiral
