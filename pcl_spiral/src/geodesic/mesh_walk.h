// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Neighbours over a triangulation's edges, and the nearest point that has a property.
 */
#pragma once

#include <pcl_spiral/graph/impl/surface_graph.h>

#include <algorithm>
#include <limits>

namespace pcl_spiral {

/** Call \p visit(j) for every point j that shares an edge with \p v. */
template <typename Visit>
void
forNeighbours(const Triangulation& mesh, std::uint32_t v, Visit visit)
{
  for (std::uint32_t i = mesh.outgoingBegin(v); i < mesh.outgoingBegin(v + 1); ++i) {
    const std::uint32_t h = mesh.outgoing(i), before = Triangulation::previous(h);
    visit(mesh.target(h));
    if (mesh.opposite(before) == Triangulation::none)
      visit(mesh.origin(before));
  }
}

/** The point nearest to \p x with accept(point), within \p reach; Triangulation::none if there is none. */
template <typename Accept>
std::uint32_t
nearestPoint(const SurfaceGraph& graph, const Eigen::Vector3d& x, double reach, Accept accept)
{
  if (!x.allFinite() || !(x.cwiseAbs().maxCoeff() < 1e15))
    return Triangulation::none;
  const PointBlocks& blocks = graph.blocks();
  const Eigen::Vector3f q = x.cast<float>();
  Box box;
  box.extend(q.data());
  std::uint32_t best = Triangulation::none;
  for (double radius = std::min(reach, graph.spacing());; radius = std::min(reach, 3.0 * radius)) {
    double least = radius * radius;
    blocks.forBlocksNear(box, static_cast<float>(least * 1.0001), [&](std::size_t b) {
      for (std::size_t i = blocks.blockBegin(b); i < blocks.blockEnd(b); ++i) {
        const double squared = (blocks.position(i) - x).squaredNorm();
        const auto index = static_cast<std::uint32_t>(i);
        if ((squared < least || (squared == least && index < best)) && accept(index)) {
          least = squared;
          best = index;
        }
      }
    });
    if (best != Triangulation::none || radius >= reach)
      return best;
  }
}

/** How far from the cloud a position may be to count as on it, mm. */
inline double
reachOf(const SurfaceGraph& graph)
{
  return 3.0 * graph.spacing();
}

inline bool
hasTriangles(const Triangulation& mesh, std::uint32_t v)
{
  return mesh.outgoingBegin(v) < mesh.outgoingBegin(v + 1);
}

} // namespace pcl_spiral
