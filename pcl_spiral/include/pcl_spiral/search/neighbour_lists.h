// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The neighbours of every point of a cloud, in one block of memory.
 */
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl_spiral {

/** Neighbours of each point, as ascending indices into the cloud. Symmetric: j is a neighbour of i iff i is
 * a neighbour of j. */
class NeighbourLists {
public:
  /** The neighbours of one point, for a range-based for. */
  class List {
  public:
    List(const std::uint32_t* first, const std::uint32_t* last) : first_(first), last_(last) {} ///< From \p first up to, without, \p last.
    const std::uint32_t* begin() const { return first_; }                                       ///< The first neighbour.
    const std::uint32_t* end() const { return last_; }                                          ///< Behind the last neighbour.
    std::size_t size() const { return static_cast<std::size_t>(last_ - first_); }               ///< Number of neighbours.
    std::uint32_t operator[](std::size_t i) const { return first_[i]; }                         ///< Neighbour \p i.

  private:
    const std::uint32_t* first_;
    const std::uint32_t* last_;
  };

  NeighbourLists() = default; ///< No points.

  /** The symmetric graph of directed edges: each edge in both directions, every neighbour once.
   *  \param point_count of the graph
   *  \param edges pairs of different points below \p point_count, in any order */
  NeighbourLists(std::size_t point_count, const std::vector<std::pair<std::uint32_t, std::uint32_t>>& edges);

  std::size_t size() const { return begin_.empty() ? 0 : begin_.size() - 1; } ///< Number of points.
  /** The neighbours of point \p i. */
  List operator[](std::size_t i) const { return {ends_.data() + begin_[i], ends_.data() + begin_[i + 1]}; }
  /** Undirected edges. */
  std::size_t edgeCount() const { return ends_.size() / 2; }
  bool contains(std::uint32_t i, std::uint32_t j) const; ///< Whether \p i and \p j are neighbours.
  /** The same graph for a cloud of \p point_count points, in which point i of this graph is \p indices[i]. \p
   * indices ascending. */
  NeighbourLists mapped(const std::vector<std::uint32_t>& indices, std::size_t point_count) const;

private:
  std::vector<std::size_t> begin_;
  std::vector<std::uint32_t> ends_;
};

} // namespace pcl_spiral
