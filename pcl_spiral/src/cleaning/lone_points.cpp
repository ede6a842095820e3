// SPDX-License-Identifier: BSD-3-Clause
#include "lone_points.h"

#include <algorithm>
#include <limits>

namespace pcl_spiral {
namespace {

/** Mark the points that belong to a part of no less than the share \p speck of the triangles. */
void
markLargeParts(const Triangulation& mesh, double speck, std::vector<std::uint8_t>& in)
{
  std::vector<std::size_t> sizes;
  const std::vector<std::uint32_t> part = mesh.parts(sizes);
  const double least = speck * static_cast<double>(mesh.triangleCount());
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t)
    if (static_cast<double>(sizes[part[t]]) >= least)
      for (const std::uint32_t v : mesh.triangle(t))
        in[v] = 1;
}

std::vector<std::uint32_t>
originalIndices(const SurfaceGraph& graph, const std::vector<std::uint8_t>& kept)
{
  std::vector<std::uint32_t> out;
  for (std::size_t i = 0; i < graph.size(); ++i)
    if (!kept[i])
      out.push_back(graph.blocks().originalIndex(i));
  std::sort(out.begin(), out.end());
  return out;
}

/** Whether the point where boundary half-edge \p h begins is \p far times their spacing from all that it shares a triangle
 *  with. Its own spacing does not count, nor that of another like it: the least one about does; and where the largest is
 *  above \p sparse, none does. */
bool
isTip(const SurfaceGraph& graph, std::uint32_t h, double far, double sparse = std::numeric_limits<double>::max())
{
  const Triangulation& mesh = graph.triangulation();
  const std::uint32_t v = mesh.origin(h);
  double nearest = std::numeric_limits<double>::max(), spacing = nearest;
  for (std::uint32_t k = mesh.outgoingBegin(v); k < mesh.outgoingBegin(v + 1); ++k)
    for (const std::uint32_t other : {mesh.target(mesh.outgoing(k)), mesh.origin(mesh.previous(mesh.outgoing(k)))}) {
      if (graph.spacing(other) > sparse)
        return false;
      nearest = std::min(nearest, (graph.position(other) - graph.position(v)).norm());
      spacing = std::min(spacing, graph.spacing(other));
    }
  return nearest > far * spacing;
}

} // namespace

std::vector<std::uint32_t>
lonePoints(const SurfaceGraph& graph)
{
  constexpr double speck = 0.005; // of all triangles
  constexpr double far = 1.25;    // times the spacing
  const Triangulation& mesh = graph.triangulation();
  std::vector<std::uint8_t> kept(graph.size(), 0);
  markLargeParts(mesh, speck, kept);
  for (std::uint32_t h = 0; h < mesh.halfEdgeCount(); ++h)
    if (mesh.opposite(h) == Triangulation::none && isTip(graph, h, far))
      kept[mesh.origin(h)] = 0;
  return originalIndices(graph, kept);
}

std::vector<std::uint32_t>
sparseSpecks(const SurfaceGraph& graph)
{
  constexpr double sparse = 2.5; // times the usual spacing
  constexpr double speck = 0.02; // of all triangles
  constexpr double spike = 5.0;  // times the spacing
  const double far = sparse * graph.spacing();
  std::vector<std::uint8_t> kept(graph.size());
  for (std::size_t i = 0; i < graph.size(); ++i)
    kept[i] = graph.spacing(i) <= far;
  if (std::find(kept.begin(), kept.end(), 0) == kept.end())
    return {};
  const std::vector<std::uint8_t> dense = kept;
  const Triangulation& mesh = graph.triangulation();
  markLargeParts(mesh, speck, kept);
  for (std::uint32_t h = 0; h < mesh.halfEdgeCount(); ++h)
    if (!dense[mesh.origin(h)] && mesh.opposite(h) == Triangulation::none && isTip(graph, h, spike, far))
      kept[mesh.origin(h)] = 0;
  return originalIndices(graph, kept);
}

} // namespace pcl_spiral
