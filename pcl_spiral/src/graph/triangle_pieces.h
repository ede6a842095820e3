// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Pieces of a triangulation. Private.
 */
#pragma once

#include <pcl_spiral/graph/impl/triangulation.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

constexpr std::size_t least_surface = 8; ///< triangles of a small surface: fewer are loose points, as of a tree

/** The piece of each triangle for which \p belongs(triangle) is true, none for the others, and the pieces' triangles in \p sizes. Triangles
 *  of one piece are connected by edges. */
template <typename Belongs>
std::vector<std::uint32_t>
trianglePieces(const Triangulation& mesh, Belongs belongs, std::vector<std::size_t>& sizes)
{
  sizes.clear();
  std::vector<std::uint32_t> piece(mesh.triangleCount(), Triangulation::none), stack;
  for (std::uint32_t t = 0; t < piece.size(); ++t) {
    if (piece[t] != Triangulation::none || !belongs(t))
      continue;
    const auto number = static_cast<std::uint32_t>(sizes.size());
    sizes.push_back(0);
    piece[t] = number;
    stack.assign(1, t);
    while (!stack.empty()) {
      const std::uint32_t from = stack.back();
      stack.pop_back();
      ++sizes[number];
      for (std::uint32_t h = 3 * from; h < 3 * from + 3; ++h)
        if (const std::uint32_t other = mesh.opposite(h);
            other != Triangulation::none && piece[other / 3] == Triangulation::none && belongs(other / 3)) {
          piece[other / 3] = number;
          stack.push_back(other / 3);
        }
    }
  }
  return piece;
}

} // namespace pcl_spiral
