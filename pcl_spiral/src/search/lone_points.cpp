#include <pcl_spiral/search/lone_points.h>

#include <algorithm>
#include <limits>

namespace pcl_spiral {
namespace {

/** Whether each point belongs to a part that is more than a speck. */
std::vector<std::uint8_t>
inLargeParts(const Triangulation& mesh, std::size_t points)
{
  constexpr double speck = 0.005; // of all triangles
  std::vector<std::size_t> sizes;
  const std::vector<std::uint32_t> part = mesh.parts(sizes);
  const double least = speck * static_cast<double>(mesh.triangleCount());
  std::vector<std::uint8_t> in(points, 0);
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t)
    if (static_cast<double>(sizes[part[t]]) >= least)
      for (const std::uint32_t v : mesh.triangle(t))
        in[v] = 1;
  return in;
}

/** Whether the point where boundary half-edge \p h begins is far from all that it shares a triangle with. Its own spacing
 *  does not count, nor that of another like it: the least one about does. */
bool
isTip(const SurfaceGraph& graph, std::uint32_t h)
{
  constexpr double far = 1.25; // times their spacing
  const Triangulation& mesh = graph.triangulation();
  const std::uint32_t v = mesh.origin(h);
  double nearest = std::numeric_limits<double>::max(), spacing = nearest;
  for (std::uint32_t k = mesh.outgoingBegin(v); k < mesh.outgoingBegin(v + 1); ++k)
    for (const std::uint32_t other : {mesh.target(mesh.outgoing(k)), mesh.origin(mesh.previous(mesh.outgoing(k)))}) {
      nearest = std::min(nearest, (graph.position(other) - graph.position(v)).norm());
      spacing = std::min(spacing, graph.spacing(other));
    }
  return nearest > far * spacing;
}

} // namespace

std::vector<std::uint32_t>
lonePoints(const SurfaceGraph& graph)
{
  const Triangulation& mesh = graph.triangulation();
  std::vector<std::uint8_t> kept = inLargeParts(mesh, graph.size());
  for (std::uint32_t h = 0; h < mesh.halfEdgeCount(); ++h)
    if (mesh.opposite(h) == Triangulation::none && isTip(graph, h))
      kept[mesh.origin(h)] = 0;
  std::vector<std::uint32_t> lone;
  for (std::size_t i = 0; i < graph.size(); ++i)
    if (!kept[i])
      lone.push_back(graph.blocks().originalIndex(i));
  std::sort(lone.begin(), lone.end());
  return lone;
}

} // namespace pcl_spiral
