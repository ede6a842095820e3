// SPDX-License-Identifier: BSD-3-Clause
#include "star_set.h"

#include <algorithm>

namespace pcl_spiral {

std::uint32_t
StarSet::slotOf(std::uint32_t v, std::uint32_t a, std::uint32_t b) const
{
  const std::uint32_t last = begin[v + 1];
  for (std::uint32_t slot = begin[v]; slot < last; ++slot)
    if (spokes[slot] == (a | triangle_flag))
      return neighbourAt(slotAfter(v, slot)) == b ? slot : none;
  return none;
}

void
StarSet::reverse(std::size_t i)
{
  const auto first = spokes.begin() + begin[i], last = spokes.begin() + begin[i + 1];
  if (first == last)
    return;
  std::reverse(first, last);
  // A triangle after a spoke is now before it: after the spoke that has become its predecessor.
  const std::uint32_t first_flag = *first & triangle_flag;
  for (auto spoke = first; spoke + 1 != last; ++spoke)
    *spoke = neighbour(*spoke) | (spoke[1] & triangle_flag);
  last[-1] = neighbour(last[-1]) | first_flag;
}

} // namespace pcl_spiral
