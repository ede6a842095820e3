// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Triangles between two things that one cloud shows.
 */
#pragma once

#include <pcl_spiral/graph/impl/surface_graph.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral::test {

/** Triangles of a graph with corners on both; \p of_second: one flag per point of the cloud. */
inline std::size_t
joiningTriangles(const SurfaceGraph& graph, const std::vector<std::uint8_t>& of_second)
{
  const Triangulation& mesh = graph.triangulation();
  std::size_t count = 0;
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
    int corners = 0;
    for (const std::uint32_t v : mesh.triangle(t))
      corners += of_second[graph.blocks().originalIndex(v)];
    count += corners == 1 || corners == 2;
  }
  return count;
}

} // namespace pcl_spiral::test
