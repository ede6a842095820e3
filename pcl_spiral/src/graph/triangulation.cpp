// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/graph/impl/triangulation.h>

#include <omp.h>

#include <algorithm>
#include <numeric>

namespace pcl_spiral {

Triangulation::Triangulation(std::size_t point_count, std::vector<Triangle> triangles)
: triangles_(std::move(triangles)), outgoing_begin_(point_count + 1, 0)
{
  findOutgoing();
  opposite_.assign(halfEdgeCount(), none);
  joinFacing();
}

/** Each thread lists the half-edges of a range of points, and looks at all triangles for them: atomic counters would take longer. */
void
Triangulation::findOutgoing()
{
  const std::size_t points = outgoing_begin_.size() - 1;
  std::vector<std::uint32_t> next(points, 0); // first counts, then where a point's next half-edge goes
  outgoing_.resize(halfEdgeCount());
#pragma omp parallel
  {
    const std::size_t threads = omp_get_num_threads(), thread = omp_get_thread_num();
    const auto first = static_cast<std::uint32_t>(points * thread / threads);
    const auto mine = static_cast<std::uint32_t>(points * (thread + 1) / threads) - first;
    const auto forMine = [&](const auto& visit) {
      for (std::size_t t = 0; t < triangleCount(); ++t)
        for (std::uint32_t i = 0; i < 3; ++i)
          if (const std::uint32_t v = triangles_[t][i]; v - first < mine)
            visit(v, static_cast<std::uint32_t>(3 * t) + i);
    };
    forMine([&](std::uint32_t v, std::uint32_t) { ++next[v]; });
#pragma omp barrier
#pragma omp single
    for (std::size_t v = 0; v < points; ++v) {
      outgoing_begin_[v + 1] = outgoing_begin_[v] + next[v];
      next[v] = outgoing_begin_[v];
    }
    forMine([&](std::uint32_t v, std::uint32_t h) { outgoing_[next[v]++] = h; });
  }
}

/** About a point, the half-edge that faces one which leaves it comes before another that leaves it. */
void
Triangulation::joinFacing()
{
  const auto points = static_cast<std::int64_t>(outgoing_begin_.size()) - 1;
  std::vector<std::uint32_t> unclear; // half-edges that face several, or not alone
#pragma omp parallel
  {
    std::vector<std::uint32_t> mine, targets, origins; // of the half-edges that leave a point, and of those before them
#pragma omp for schedule(static) nowait
    for (std::int64_t v = 0; v < points; ++v) {
      targets.clear();
      origins.clear();
      for (std::uint32_t k = outgoing_begin_[v]; k < outgoing_begin_[v + 1]; ++k) {
        const Triangle& t = triangles_[outgoing_[k] / 3];
        const std::uint32_t i = outgoing_[k] % 3;
        targets.push_back(t[(i + 1) % 3]);
        origins.push_back(t[(i + 2) % 3]);
      }
      for (std::size_t k = 0; k < targets.size(); ++k) {
        const std::uint32_t h = outgoing_[outgoing_begin_[v] + k], target = targets[k];
        std::uint32_t facing = 0, same = 0, at = 0;
        for (std::uint32_t j = 0; j < targets.size(); ++j) {
          same += targets[j] == target;
          facing += origins[j] == target;
          at = origins[j] == target ? j : at;
        }
        if (facing == 1 && same == 1)
          opposite_[h] = previous(outgoing_[outgoing_begin_[v] + at]);
        else if (facing > 0)
          mine.push_back(h);
      }
    }
#pragma omp critical(pcl_spiral_triangulation)
    unclear.insert(unclear.end(), mine.begin(), mine.end());
  }
  std::sort(unclear.begin(), unclear.end());
  for (const std::uint32_t h : unclear)
    join(h);
}

void
Triangulation::join(std::uint32_t h)
{
  const std::uint32_t from = origin(h), to = target(h);
  for (std::uint32_t k = outgoing_begin_[to]; k < outgoing_begin_[to + 1] && opposite_[h] == none; ++k) {
    const std::uint32_t facing = outgoing_[k];
    if (target(facing) == from && opposite_[facing] == none) {
      opposite_[h] = facing;
      opposite_[facing] = h;
    }
  }
}

Triangulation::Triangulation(std::vector<Triangle> triangles, std::vector<std::uint32_t> opposite,
                             std::vector<std::uint32_t> outgoing_begin, std::vector<std::uint32_t> outgoing)
: triangles_(std::move(triangles)), opposite_(std::move(opposite)), outgoing_begin_(std::move(outgoing_begin)),
  outgoing_(std::move(outgoing))
{}

void
Triangulation::append(const std::vector<Triangle>& triangles)
{
  if (triangles.empty())
    return;
  const auto first = static_cast<std::uint32_t>(halfEdgeCount());
  triangles_.insert(triangles_.end(), triangles.begin(), triangles.end());
  opposite_.resize(halfEdgeCount(), none);
  insertOutgoing(first);
  for (std::uint32_t h = first; h < halfEdgeCount(); ++h)
    join(h);
}

void
Triangulation::insertOutgoing(std::uint32_t first_half_edge)
{
  std::vector<std::uint32_t> end_of(outgoing_begin_.size(), 0); // of each point's share of the new half-edges
  for (std::uint32_t h = first_half_edge; h < halfEdgeCount(); ++h)
    ++end_of[origin(h)];
  std::partial_sum(end_of.begin(), end_of.end(), end_of.begin());
  std::vector<std::uint32_t> added(halfEdgeCount() - first_half_edge); // by their origins, ascending
  for (std::size_t h = halfEdgeCount(); h-- > first_half_edge;)
    added[--end_of[origin(static_cast<std::uint32_t>(h))]] = static_cast<std::uint32_t>(h);
  outgoing_.resize(halfEdgeCount());
  // From the last point backwards, each list moves up by the number of entries added before it.
  for (std::size_t v = outgoing_begin_.size() - 1, left = added.size(); v-- > 0 && left > 0;) {
    const std::uint32_t begin = outgoing_begin_[v], end = outgoing_begin_[v + 1];
    const auto after = static_cast<std::uint32_t>(left);
    while (left > 0 && origin(added[left - 1]) == v)
      --left;
    std::copy_backward(outgoing_.begin() + begin, outgoing_.begin() + end, outgoing_.begin() + end + left);
    for (std::size_t k = left; k < after; ++k)
      outgoing_[end + k] = added[k];
    outgoing_begin_[v + 1] = end + after;
  }
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
  // Union of sets by their first triangle: first runs of triangles in parallel, then the edges between runs.
  const std::size_t n = triangleCount();
  constexpr std::size_t runs = 64;
  std::vector<std::uint32_t> first(n);
  std::iota(first.begin(), first.end(), 0u);
  const auto firstOf = [&](std::uint32_t t) {
    while (first[t] != t)
      t = first[t] = first[first[t]];
    return t;
  };
  const auto unite = [&](std::uint32_t t, std::uint32_t other) {
    t = firstOf(t);
    other = firstOf(other);
    first[std::max(t, other)] = std::min(t, other);
  };
  std::vector<std::vector<std::uint32_t>> between(runs); // half-edges to other runs
#pragma omp parallel for schedule(dynamic, 1)
  for (std::int64_t r = 0; r < static_cast<std::int64_t>(runs); ++r) {
    const std::size_t begin = n * r / runs, end = n * (r + 1) / runs;
    for (std::size_t h = 3 * begin; h < 3 * end; ++h) {
      const std::uint32_t other = opposite_[h];
      if (other == none || other > h)
        continue;
      if (other >= 3 * begin)
        unite(static_cast<std::uint32_t>(h / 3), other / 3);
      else
        between[r].push_back(static_cast<std::uint32_t>(h));
    }
  }
  for (const auto& run : between)
    for (const std::uint32_t h : run)
      unite(h / 3, opposite_[h] / 3);
  std::vector<std::uint32_t> part(n);
  sizes.clear();
  for (std::uint32_t t = 0; t < n; ++t) { // a set's first triangle comes before its others
    const std::uint32_t f = firstOf(t);
    if (f == t) {
      part[t] = static_cast<std::uint32_t>(sizes.size());
      sizes.push_back(0);
    }
    part[t] = part[f];
    ++sizes[part[t]];
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
