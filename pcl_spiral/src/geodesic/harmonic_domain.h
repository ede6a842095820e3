// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The piece of surface between a centre or inner loop and the rim.
 */
#pragma once

#include <pcl_spiral/graph/impl/surface_graph.h>

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace pcl_spiral {

/** What bounds a harmonic function, in half-edges of the graph's triangulation. */
struct HarmonicDomain {
  enum class Edge : std::uint8_t { Inside, Rim, Inner, Gap, Pocket, Elsewhere };

  std::vector<std::uint32_t> rim; ///< the outer loop, in order, surface on the left
  std::vector<std::vector<std::uint32_t>> gaps;
  std::unordered_map<std::uint32_t, std::uint32_t> after; ///< next half-edge round a pocket, a gap too small to matter
  std::vector<Edge> kind;                                 ///< of each half-edge; Elsewhere: not joined to the rim
  std::vector<std::uint32_t> edges;                       ///< one half-edge an edge
  std::vector<std::int8_t> cut;                           ///< of each half-edge: +1 where it crosses the cut from the centre to the
                                                          ///< rim counter-clockwise, -1 the other way
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  std::vector<std::uint32_t> disc;   ///< points about the centre
  std::vector<double> disc_angle;    ///< direction from the centre to each, continued across its branch except
                                     ///< at the cut
  std::vector<double> disc_radius;   ///< distance of each over the disc's radius
  std::vector<std::uint8_t> in_disc; ///< of each point
};

/** One boundary: about \p centre. */
Status makeDomain(const SurfaceGraph& graph, const Eigen::Vector3d& centre, const std::vector<std::uint32_t>& rim_points,
                  HarmonicDomain& domain);

/** Two boundaries. */
Status makeDomain(const SurfaceGraph& graph, const std::vector<std::uint32_t>& inner_points, const std::vector<std::uint32_t>& rim_points,
                  HarmonicDomain& domain);

} // namespace pcl_spiral
