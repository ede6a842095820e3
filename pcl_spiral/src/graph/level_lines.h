// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Lines along which a function of a triangulation's points is constant.
 */
#pragma once

#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/graph/impl/surface_graph.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Where a level line crosses an edge: at (1 - share) of its point below the level and share of the one
 * above. */
struct LevelCrossing {
  std::uint32_t below = 0, above = 0;
  double share = 0.0; ///< above 0, up to 1
  /** Half-edge of the triangle that the line leaves there; at the start of a line, of the triangle that it enters. */
  std::uint32_t half_edge = Triangulation::none;
};

/** A level line from triangle to triangle. The points above the level are on its left, seen from outside the
 * material. */
struct LevelLine {
  std::vector<LevelCrossing> crossings; ///< one per edge; a closed line does not repeat its first
  bool closed = false;                  ///< open lines end at the boundary of the triangulation
};

/** The lines of each of ascending \p levels of a function that is linear over the triangles and has one of \p
 * values at each point. Triangles with a value that is not finite are ignored.
 *
 *  A point with the value of a level counts as above it: no line runs through a point or along an edge, and each
 * triangle and each edge is crossed at most once. In the order of their first triangles, open
 * lines before closed ones; the same for any number of threads. */
std::vector<std::vector<LevelLine>> levelLines(const Triangulation& mesh, const std::vector<double>& values,
                                               const std::vector<double>& levels);

/** The lines of one \p level through only the given \p triangles (ascending); lines that leave them are open there. */
std::vector<LevelLine> levelLines(const Triangulation& mesh, const std::vector<double>& values, double level,
                                  const std::vector<std::uint32_t>& triangles);

/** The line in space. */
Polyline pointsOf(const LevelLine& line, const PointBlocks& points);

} // namespace pcl_spiral
