// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The moves of a cutter in a tree by tip and axis. Private to verify.
 */
#pragma once

#include <pcl_spiral/core/polyline.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Places of a cutter: the tips are in a box along its own directions, the axes within an angle of their middle. */
struct SweptPlaces {
  Eigen::Vector3d tip, axis; ///< in the middle
  Eigen::Matrix3d sides;     ///< columns: directions of the box, unit
  Eigen::Vector3d half;      ///< of the box, mm
  double turn = 0.0;         ///< largest angle of an axis against the middle one, radians
  std::uint32_t first = 0;   ///< of a leaf: its first piece; else its first child, which the second follows
  std::uint32_t pieces = 0;  ///< of a leaf; 0: it has children
};

/** Moves of any cutter, halved repeatedly across the direction in which their tips spread most. Moves much longer than the mean are
 *  stored in pieces. The path follows a surface, so that the boxes are thin where the tips turn to the surface. Memory: 110 bytes a move,
 *  at most half as much again. */
class SweepTree {
public:
  /** One tip and one unit axis per point. Moves that end at one of \p passes are left out. */
  SweepTree(const Polyline& tips, const std::vector<Eigen::Vector3d>& axes, const std::vector<std::size_t>& passes);

  /** Calls \p test(move) for every move in places of which \p bound is above 0, those with a higher bound first. \p bound may become less
   *  with every test. A move may be passed twice. */
  template <typename Bound, typename Test>
  void search(const Bound& bound, const Test& test) const
  {
    if (nodes_.empty())
      return;
    struct Entry {
      std::uint32_t node;
      double bound;
      std::size_t tested; ///< moves, when the bound was found
    };
    std::array<Entry, 64> stack;
    std::size_t top = 0, tested = 0;
    const auto entry = [&](std::uint32_t node) { return Entry{node, bound(nodes_[node]), tested}; };
    stack[top++] = entry(0);
    while (top > 0) {
      const Entry last = stack[--top];
      if (last.bound <= 0.0 || (last.tested < tested && bound(nodes_[last.node]) <= 0.0))
        continue;
      const SweptPlaces& places = nodes_[last.node];
      if (places.pieces > 0) {
        for (std::uint32_t i = places.first; i < places.first + places.pieces; ++i, ++tested)
          test(static_cast<std::size_t>(moves_[i]));
        continue;
      }
      const Entry first = entry(places.first), second = entry(places.first + 1);
      const bool swapped = second.bound > first.bound;
      stack[top++] = swapped ? first : second;
      stack[top++] = swapped ? second : first;
    }
  }

private:
  struct Piece {
    Eigen::Vector3d from, to;
    std::uint32_t move;
  };

  std::vector<Piece> piecesOf(const Polyline& tips, const std::vector<std::size_t>& passes) const;
  SweptPlaces placesOf(const std::vector<Piece>& pieces, std::size_t first, std::size_t last,
                       const std::vector<Eigen::Vector3d>& axes) const;
  void build(std::vector<Piece>& pieces, std::size_t first, std::size_t last, const std::vector<Eigen::Vector3d>& axes, std::size_t node);

  std::vector<SweptPlaces> nodes_;
  std::vector<std::uint32_t> moves_; ///< of each piece
};

} // namespace pcl_spiral
