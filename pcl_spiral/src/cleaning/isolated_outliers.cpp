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

/** The points that share a triangle with \p v. */
std::vector<std::uint32_t>
sharing(const Triangulation& mesh, std::uint32_t v)
{
  std::vector<std::uint32_t> others;
  for (std::uint32_t k = mesh.outgoingBegin(v); k < mesh.outgoingBegin(v + 1); ++k) {
    others.push_back(mesh.target(mesh.outgoing(k)));
    others.push_back(mesh.origin(Triangulation::previous(mesh.outgoing(k))));
  }
  return others;
}

bool
isOnBoundary(const Triangulation& mesh, std::uint32_t v)
{
  for (std::uint32_t k = mesh.outgoingBegin(v); k < mesh.outgoingBegin(v + 1); ++k)
    if (mesh.opposite(mesh.outgoing(k)) == Triangulation::none)
      return true;
  return false;
}

/** Whether \p v is farther than \p far spacings from all of \p others. The spacing is the least of theirs: that of \p v, and of another
 *  tip, are too large. */
bool
isFar(const SurfaceGraph& graph, std::uint32_t v, const std::vector<std::uint32_t>& others, double far)
{
  double nearest = std::numeric_limits<double>::max(), spacing = nearest;
  for (const std::uint32_t other : others) {
    nearest = std::min(nearest, (graph.position(other) - graph.position(v)).norm());
    spacing = std::min(spacing, graph.spacing(other));
  }
  return others.empty() || nearest > far * spacing;
}

/** Walks over the sparse points that triangles join to each other. */
class SparseGroups {
public:
  SparseGroups(const SurfaceGraph& graph, const std::vector<std::uint8_t>& dense) : graph_(graph), dense_(dense), seen_(dense) {}

  /** The group of sparse point \p v, if it was in none before and hangs on dense points, all of them farther than \p far spacings; no
   *  point otherwise, and if sparse points surround one of them: then it is a sparser part of the surface. */
  std::vector<std::uint32_t> hanging(std::uint32_t v, double far)
  {
    std::vector<std::uint32_t> group;
    bool is_surface = false, hangs = false;
    join(v, group);
    for (std::size_t i = 0; i < group.size(); ++i) {
      std::vector<std::uint32_t> beside;
      for (const std::uint32_t other : sharing(graph_.triangulation(), group[i]))
        if (dense_[other])
          beside.push_back(other);
        else
          join(other, group);
      hangs = hangs || !beside.empty();
      const bool surrounded = beside.empty() && !isOnBoundary(graph_.triangulation(), group[i]);
      is_surface = is_surface || surrounded || !isFar(graph_, group[i], beside, far);
    }
    return hangs && !is_surface ? group : std::vector<std::uint32_t>();
  }

private:
  void join(std::uint32_t v, std::vector<std::uint32_t>& group)
  {
    if (!seen_[v])
      group.push_back(v);
    seen_[v] = 1;
  }

  const SurfaceGraph& graph_;
  const std::vector<std::uint8_t>& dense_;
  std::vector<std::uint8_t> seen_;
};

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
    if (const std::uint32_t v = mesh.origin(h); mesh.opposite(h) == Triangulation::none && isFar(graph, v, sharing(mesh, v), far))
      kept[v] = 0;
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
  markLargeParts(graph.triangulation(), least_share, kept);
  SparseGroups groups(graph, dense);
  for (std::uint32_t v = 0; v < graph.size(); ++v)
    if (!dense[v])
      for (const std::uint32_t loose : groups.hanging(v, spike))
        kept[loose] = 0;
  return originalIndices(graph, kept);
}

} // namespace pcl_spiral
