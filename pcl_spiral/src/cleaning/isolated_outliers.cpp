// SPDX-License-Identifier: BSD-3-Clause
#include "isolated_outliers.h"

#include <algorithm>
#include <limits>

namespace pcl_spiral {
namespace {

/** Mark the points that belong to a part with at least the share \p least_share of the triangles. */
void
markLargeParts(const Triangulation& mesh, double least_share, std::vector<std::uint8_t>& in)
{
  std::vector<std::size_t> sizes;
  const std::vector<std::uint32_t> part = mesh.parts(sizes);
  const double least = least_share * static_cast<double>(mesh.triangleCount());
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

/** Whether the point where boundary half-edge \p h begins is farther than \p far spacings from all points that it shares a triangle
 *  with. The spacing is the least of these points': its own, and that of another tip, are too large. False if one of them is above
 *  \p sparse. */
bool
isTip(const SurfaceGraph& graph, std::uint32_t h, double far, double sparse = std::numeric_limits<double>::max())
{
  const Triangulation& mesh = graph.triangulation();
  const std::uint32_t v = mesh.origin(h);
  double nearest = std::numeric_limits<double>::max(), spacing = nearest;
  for (std::uint32_t k = mesh.outgoingBegin(v); k < mesh.outgoingBegin(v + 1); ++k)
    for (const std::uint32_t other : {mesh.target(mesh.outgoing(k)), mesh.origin(Triangulation::previous(mesh.outgoing(k)))}) {
      if (graph.spacing(other) > sparse)
        return false;
      nearest = std::min(nearest, (graph.position(other) - graph.position(v)).norm());
      spacing = std::min(spacing, graph.spacing(other));
    }
  return nearest > far * spacing;
}

} // namespace

std::vector<std::uint32_t>
isolatedOutliers(const SurfaceGraph& graph)
{
  constexpr double least_share = 0.005; // of all triangles
  constexpr double far = 1.25;          // times the spacing
  const Triangulation& mesh = graph.triangulation();
  std::vector<std::uint8_t> kept(graph.size(), 0);
  markLargeParts(mesh, least_share, kept);
  for (std::uint32_t h = 0; h < mesh.halfEdgeCount(); ++h)
    if (mesh.opposite(h) == Triangulation::none && isTip(graph, h, far))
      kept[mesh.origin(h)] = 0;
  return originalIndices(graph, kept);
}

std::vector<std::uint32_t>
sparseClusters(const SurfaceGraph& graph)
{
  constexpr double sparse = 2.5;       // times the usual spacing
  constexpr double least_share = 0.02; // of all triangles
  constexpr double spike = 5.0;        // times the spacing
  const double far = sparse * graph.spacing();
  std::vector<std::uint8_t> kept(graph.size());
  for (std::size_t i = 0; i < graph.size(); ++i)
    kept[i] = graph.spacing(i) <= far;
  if (std::find(kept.begin(), kept.end(), 0) == kept.end())
    return {};
  const std::vector<std::uint8_t> dense = kept;
  const Triangulation& mesh = graph.triangulation();
  markLargeParts(mesh, least_share, kept);
  for (std::uint32_t h = 0; h < mesh.halfEdgeCount(); ++h)
    if (!dense[mesh.origin(h)] && mesh.opposite(h) == Triangulation::none && isTip(graph, h, spike, far))
      kept[mesh.origin(h)] = 0;
  return originalIndices(graph, kept);
}

} // namespace pcl_spiral
