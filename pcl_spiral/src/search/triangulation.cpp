#include <pcl_spiral/search/triangulation.h>

#include <algorithm>
#include <numeric>

namespace pcl_spiral {

Triangulation::Triangulation(std::size_t point_count, std::vector<Triangle> triangles)
: triangles_(std::move(triangles))
{
  outgoing_begin_.assign(point_count + 1, 0);
  for (const Triangle& t : triangles_)
    for (const std::uint32_t v : t)
      ++outgoing_begin_[v + 1];
  std::partial_sum(outgoing_begin_.begin(), outgoing_begin_.end(), outgoing_begin_.begin());
  outgoing_.resize(halfEdgeCount());
  std::vector<std::uint32_t> place(outgoing_begin_.begin(), outgoing_begin_.end() - 1);
  for (std::uint32_t h = 0; h < halfEdgeCount(); ++h)
    outgoing_[place[origin(h)]++] = h;

  std::vector<std::uint32_t> facing(halfEdgeCount(), none);
  const auto count = static_cast<std::int64_t>(halfEdgeCount());
#pragma omp parallel for schedule(static)
  for (std::int64_t i = 0; i < count; ++i) {
    const auto h = static_cast<std::uint32_t>(i);
    const std::uint32_t from = origin(h), to = target(h);
    for (std::uint32_t k = outgoing_begin_[to]; k < outgoing_begin_[to + 1]; ++k)
      if (target(outgoing_[k]) == from)
        facing[h] = outgoing_[k];
  }
  // Where more than two triangles meet in an edge only a pair that faces each other is joined: then every turn about a
  // point ends.
  opposite_.assign(halfEdgeCount(), none);
#pragma omp parallel for schedule(static)
  for (std::int64_t i = 0; i < count; ++i)
    if (facing[i] != none && facing[facing[i]] == static_cast<std::uint32_t>(i))
      opposite_[i] = facing[i];
}

std::vector<std::vector<std::uint32_t>>
Triangulation::boundaryLoops() const
{
  std::vector<std::vector<std::uint32_t>> loops;
  std::vector<std::uint8_t> seen(halfEdgeCount(), 0);
  for (std::uint32_t first = 0; first < halfEdgeCount(); ++first) {
    if (opposite_[first] != none || seen[first])
      continue;
    loops.emplace_back();
    std::uint32_t h = first;
    do {
      seen[h] = 1;
      loops.back().push_back(h);
      // Turn about the target, through its triangles, to the next half-edge without a neighbour.
      h = next(h);
      while (opposite_[h] != none)
        h = next(opposite_[h]);
    } while (!seen[h]);
  }
  return loops;
}

std::vector<std::uint32_t>
Triangulation::parts(std::vector<std::size_t>& sizes) const
{
  std::vector<std::uint32_t> part(triangleCount(), none);
  std::vector<std::uint32_t> stack;
  sizes.clear();
  for (std::uint32_t seed = 0; seed < triangleCount(); ++seed) {
    if (part[seed] != none)
      continue;
    const auto id = static_cast<std::uint32_t>(sizes.size());
    sizes.push_back(0);
    part[seed] = id;
    stack.push_back(seed);
    while (!stack.empty()) {
      const std::uint32_t t = stack.back();
      stack.pop_back();
      ++sizes.back();
      for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h)
        if (opposite_[h] != none && part[opposite_[h] / 3] == none) {
          part[opposite_[h] / 3] = id;
          stack.push_back(opposite_[h] / 3);
        }
    }
  }
  std::vector<std::uint32_t> order(sizes.size()), rank(sizes.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return sizes[a] > sizes[b]; });
  for (std::uint32_t i = 0; i < order.size(); ++i)
    rank[order[i]] = i;
  for (std::uint32_t& p : part)
    p = rank[p];
  std::sort(sizes.begin(), sizes.end(), std::greater<>());
  return part;
}

} // namespace pcl_spiral
