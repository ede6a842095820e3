// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/search/impl/box_tree.h>

#include <algorithm>
#include <numeric>

namespace pcl_spiral {

BoxTree::BoxTree(const std::vector<Box>& boxes)
: order_(boxes.size()), boxes_(boxes.empty() ? 0 : 2 * boxes.size() - 1), lowest_(boxes_.size())
{
  std::iota(order_.begin(), order_.end(), 0u);
  if (!boxes.empty())
    build(boxes, root());
}

void
BoxTree::build(const std::vector<Box>& boxes, const Node& node)
{
  if (node.isItem()) {
    lowest_[node.number] = order_[node.begin];
    boxes_[node.number] = boxes[order_[node.begin]];
    return;
  }
  const auto middle = [&](std::uint32_t i, int d) { return boxes[i].low[d] + boxes[i].high[d]; };
  Box middles;
  for (std::uint32_t k = node.begin; k < node.end; ++k) {
    const float p[3] = {middle(order_[k], 0), middle(order_[k], 1), middle(order_[k], 2)};
    middles.extend(p);
  }
  int longest = 0;
  for (int d = 1; d < 3; ++d)
    if (middles.high[d] - middles.low[d] > middles.high[longest] - middles.low[longest])
      longest = d;
  std::nth_element(order_.begin() + node.begin, order_.begin() + node.middle(), order_.begin() + node.end,
                   [&](std::uint32_t a, std::uint32_t b) {
                     const float x = middle(a, longest), y = middle(b, longest);
                     return x != y ? x < y : a < b;
                   });
  build(boxes, node.lower());
  build(boxes, node.upper());
  boxes_[node.number] = box(node.lower());
  boxes_[node.number].extend(box(node.upper()));
  lowest_[node.number] = std::min(lowestItem(node.lower()), lowestItem(node.upper()));
}

} // namespace pcl_spiral
