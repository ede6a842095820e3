// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A binary tree of boxes, halved down to single ones.
 */
#pragma once

#include <pcl_spiral/search/impl/point_blocks.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Items under a binary tree of their boxes. The items of each node are halved across the longest side of the box of the middles
 *  of their boxes. A node is a range of items. Its number is its place when the tree is walked with the first half first. Memory:
 *  60 bytes per item. The same for any number of threads. */
class BoxTree {
public:
  struct Node {
    std::uint32_t number = 0, begin = 0, end = 0; ///< items begin to end in tree order

    bool isItem() const { return end - begin == 1; }
    Node lower() const { return {number + 1, begin, middle()}; }
    Node upper() const { return {number + 2 * (middle() - begin), middle(), end}; }
    std::uint32_t middle() const { return begin + (end - begin) / 2; }
  };

  BoxTree() = default;
  explicit BoxTree(const std::vector<Box>& boxes);

  std::size_t size() const { return order_.size(); }
  Node root() const { return {0, 0, static_cast<std::uint32_t>(order_.size())}; }
  const Box& box(const Node& node) const { return boxes_[node.number]; }
  /** Index, among the given boxes, of the one at \p place in tree order. */
  std::uint32_t item(std::size_t place) const { return order_[place]; }
  /** The lowest item() of a node. */
  std::uint32_t lowestItem(const Node& node) const { return lowest_[node.number]; }

  /** Call \p visit(place) for every item under boxes that all pass \p keep(box), in a fixed order. */
  template <typename Keep, typename Visit>
  void forItems(Keep keep, Visit visit) const
  {
    Node stack[64];
    std::size_t top = 0;
    if (size() > 0)
      stack[top++] = root();
    while (top > 0) {
      const Node node = stack[--top];
      if (!keep(box(node)))
        continue;
      if (node.isItem()) {
        visit(node.begin);
        continue;
      }
      stack[top++] = node.upper();
      stack[top++] = node.lower();
    }
  }

private:
  void build(const std::vector<Box>& boxes, const Node& node);

  std::vector<std::uint32_t> order_;
  std::vector<Box> boxes_;
  std::vector<std::uint32_t> lowest_;
};

} // namespace pcl_spiral
