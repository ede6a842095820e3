// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Triangles over the points of a surface, with their neighbours.
 */
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl_spiral {

/** An oriented, edge-manifold triangulation. Half-edge h = 3 t + i leaves corner i of triangle t; triangles run
 *  counter-clockwise seen from outside the material.
 */
class Triangulation {
public:
  using Triangle = std::array<std::uint32_t, 3>;
  static constexpr std::uint32_t none = 0xffffffffu;

  Triangulation() = default;
  Triangulation(std::size_t point_count, std::vector<Triangle> triangles);
  /** Made from its parts, which must fit together: \p opposite of each half-edge; half-edges that leave point v in \p outgoing
   *  from outgoing_begin[v] to outgoing_begin[v + 1]. */
  Triangulation(std::vector<Triangle> triangles, std::vector<std::uint32_t> opposite, std::vector<std::uint32_t> outgoing_begin,
                std::vector<std::uint32_t> outgoing);

  /** Add triangles of the same points. Each half-edge is joined to one that faces it and has no neighbour yet, if there is
   *  one. Never more than two triangles meet at an edge, so that every walk around a point ends. */
  void append(const std::vector<Triangle>& triangles);

  /** Its triangles, for another; nothing is left here. */
  std::vector<Triangle> release() && { return std::move(triangles_); }

  std::size_t triangleCount() const { return triangles_.size(); }
  const Triangle& triangle(std::size_t t) const { return triangles_[t]; }
  std::size_t halfEdgeCount() const { return 3 * triangles_.size(); }

  static std::uint32_t next(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static std::uint32_t previous(std::uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
  std::uint32_t origin(std::uint32_t h) const { return triangles_[h / 3][h % 3]; }
  std::uint32_t target(std::uint32_t h) const { return origin(next(h)); }
  /** The half-edge of the neighbouring triangle on the same edge, or none on the boundary. */
  std::uint32_t opposite(std::uint32_t h) const { return opposite_[h]; }
  /** Half-edges that leave point \p v: outgoing(i) for i from outgoingBegin(v) to outgoingBegin(v + 1). */
  std::uint32_t outgoingBegin(std::size_t v) const { return outgoing_begin_[v]; }
  std::uint32_t outgoing(std::size_t i) const { return outgoing_[i]; }

  /** Closed sequences of boundary half-edges, in order; the surface lies on their left. */
  std::vector<std::vector<std::uint32_t>> boundaryLoops() const;

  /** Number of edge-connected parts, and the part of each triangle; part 0 has the most triangles. */
  std::vector<std::uint32_t> parts(std::vector<std::size_t>& sizes) const;

private:
  void findOutgoing();
  void joinFacing();
  void join(std::uint32_t h);
  void insertOutgoing(std::uint32_t first_half_edge);

  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> opposite_;
  std::vector<std::uint32_t> outgoing_begin_, outgoing_;
};

} // namespace pcl_spiral
