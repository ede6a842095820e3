// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_strips.h"

#include <algorithm>
#include <cstddef>

namespace pcl_spiral {
namespace {

using Flags = std::vector<std::uint8_t>;

/** Corners of the triangles between \p kept points (1), and those of them on their boundary (2). */
Flags
boundaryOf(const SurfaceGraph& graph, const Flags& kept)
{
  const Triangulation& mesh = graph.triangulation();
  const auto isKept = [&](std::size_t t) {
    const Triangulation::Triangle corners = mesh.triangle(t);
    return std::all_of(corners.begin(), corners.end(), [&](std::uint32_t v) { return kept[v] != 0; });
  };
  Flags state(graph.size(), 0);
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
    if (!isKept(t))
      continue;
    for (auto h = static_cast<std::uint32_t>(3 * t); h < 3 * t + 3; ++h) {
      const std::uint32_t other = mesh.opposite(h);
      const bool inside = other != Triangulation::none && isKept(other / 3);
      for (const std::uint32_t v : {mesh.origin(h), mesh.target(h)})
        state[v] = std::max<std::uint8_t>(state[v], inside ? 1 : 2);
    }
  }
  return state;
}

/** One flag per point: whether \p isIn holds for it, and a point for which \p isFrom holds is within \p reach. */
template <typename From, typename In>
Flags
near(const SurfaceGraph& graph, From isFrom, In isIn, double reach)
{
  std::vector<Eigen::Vector3f> from;
  for (std::size_t i = 0; i < graph.size(); ++i)
    if (isFrom(i))
      from.push_back(graph.blocks().point(i));
  Flags found(graph.size(), 0);
  if (from.empty())
    return found;
  const PointBlocks blocks(std::move(from));
#pragma omp parallel for schedule(dynamic, 1024)
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(graph.size()); ++i)
    found[i] = isIn(i) && (blocks.position(blocks.nearest(graph.position(i))) - graph.position(i)).norm() <= reach;
  return found;
}

/** The places between \p kept points that a disc as wide as \p width covers without reaching over their boundary (an opening). */
Flags
widePlaces(const SurfaceGraph& graph, const Flags& kept, double width)
{
  const Flags state = boundaryOf(graph, kept);
  const Flags by_boundary = near(
      graph, [&](std::size_t i) { return state[i] == 2; }, [&](std::size_t i) { return state[i] > 0; }, 0.5 * width);
  return near(
      graph, [&](std::size_t i) { return state[i] > 0 && !by_boundary[i]; }, [&](std::size_t i) { return kept[i] != 0; },
      0.5 * width + 2.0 * graph.spacing()); // there are few points in the middle of the disc
}

} // namespace

std::vector<std::uint8_t>
narrowStrips(const SurfaceGraph& graph, const std::vector<std::uint8_t>& kept, double width)
{
  const Flags before = widePlaces(graph, Flags(graph.size(), 1), width), after = widePlaces(graph, kept, width);
  Flags narrow(graph.size());
  for (std::size_t i = 0; i < narrow.size(); ++i)
    narrow[i] = kept[i] && before[i] && !after[i];
  return narrow;
}

} // namespace pcl_spiral
