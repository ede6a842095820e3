/** \file
 *  The stars of all points, and the triangles their owners agree on. Private to search.
 */
#pragma once

#include <pcl_spiral/search/triangulation.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Stars in one array: the spokes of point i stand at begin[i] to begin[i + 1], counter-clockwise about its normal. */
struct StarSet {
  static constexpr std::uint32_t triangle_flag = 0x80000000u; ///< a triangle stands between this spoke and the next

  std::vector<std::uint32_t> begin;
  std::vector<std::uint32_t> spokes;

  static std::uint32_t neighbour(std::uint32_t spoke) { return spoke & ~triangle_flag; }

  /** Turn the star of point \p i round, for a normal that was flipped. */
  void reverse(std::size_t i);

  /** Whether the star of \p v has the triangle (v, a, b). */
  bool hasTriangle(std::uint32_t v, std::uint32_t a, std::uint32_t b) const;

  /** Triangles all three of whose corners agree; then, where half-edges are still free, those that two corners have
   *  and those that one has; then the pinholes left by disagreement, of at most \p pinhole_edges edges, closed. */
  std::vector<Triangulation::Triangle> agreedTriangles(int pinhole_edges) const;
};

} // namespace pcl_spiral
