// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/search/neighbour_lists.h>

#include <algorithm>

namespace pcl_spiral {

NeighbourLists::NeighbourLists(std::size_t point_count, const std::vector<std::pair<std::uint32_t, std::uint32_t>>& edges)
{
  std::vector<std::size_t> start(point_count + 1, 0);
  for (const auto& [a, b] : edges) {
    ++start[a + 1];
    ++start[b + 1];
  }
  for (std::size_t i = 0; i < point_count; ++i)
    start[i + 1] += start[i];
  std::vector<std::uint32_t> all(2 * edges.size());
  std::vector<std::size_t> fill(start.begin(), start.end() - 1);
  for (const auto& [a, b] : edges) {
    all[fill[a]++] = b;
    all[fill[b]++] = a;
  }
  begin_.assign(point_count + 1, 0);
  ends_.reserve(all.size());
  for (std::size_t i = 0; i < point_count; ++i) {
    const auto first = all.begin() + static_cast<std::ptrdiff_t>(start[i]);
    const auto last = all.begin() + static_cast<std::ptrdiff_t>(start[i + 1]);
    std::sort(first, last);
    ends_.insert(ends_.end(), first, std::unique(first, last));
    begin_[i + 1] = ends_.size();
  }
  ends_.shrink_to_fit();
}

bool
NeighbourLists::contains(std::uint32_t i, std::uint32_t j) const
{
  const List list = (*this)[i];
  return std::binary_search(list.begin(), list.end(), j);
}

NeighbourLists
NeighbourLists::mapped(const std::vector<std::uint32_t>& indices, std::size_t point_count) const
{
  NeighbourLists result;
  result.begin_.assign(point_count + 1, 0);
  for (std::size_t i = 0; i < size(); ++i)
    result.begin_[indices[i] + 1] = (*this)[i].size();
  for (std::size_t i = 0; i < point_count; ++i)
    result.begin_[i + 1] += result.begin_[i];
  result.ends_.reserve(ends_.size());
  for (const std::uint32_t end : ends_)
    result.ends_.push_back(indices[end]);
  return result;
}

} // namespace pcl_spiral
