// SPDX-License-Identifier: BSD-3-Clause
#include "edge_walk.h"

#include "ridge_climb.h"

#include <algorithm>
#include <atomic>
#include <limits>

namespace pcl_spiral {
namespace {

/** Marked nodes with neighbours that are not. */
std::vector<std::uint32_t>
outermost(const Triangulation& triangles, const std::vector<std::uint8_t>& marked)
{
  std::vector<std::uint8_t> is_outermost(marked.size(), 0);
  const auto count = static_cast<std::int64_t>(marked.size());
#pragma omp parallel for schedule(static, 4096)
  for (std::int64_t v = 0; v < count; ++v)
    if (marked[v])
      forNeighbours(triangles, static_cast<std::uint32_t>(v), [&](std::uint32_t w) { is_outermost[v] = is_outermost[v] || !marked[w]; });
  std::vector<std::uint32_t> found;
  for (std::uint32_t v = 0; v < marked.size(); ++v)
    if (is_outermost[v])
      found.push_back(v);
  return found;
}

} // namespace

/** In rounds: all nodes with a new way look at their neighbours in parallel. The order, and who finds a way first, do not matter: a node
 *  is in the next round when a shorter way to it is found, and the shortest remains. */
std::vector<float>
walkedFrom(const StepOverMesh& mesh, const std::vector<std::uint8_t>& from, double reach)
{
  const auto size = static_cast<std::int64_t>(mesh.size());
  std::vector<std::atomic<float>> reached(size);
  std::vector<std::atomic<bool>> waits(size);
#pragma omp parallel for schedule(static)
  for (std::int64_t v = 0; v < size; ++v)
    reached[v].store(from[v] ? 0.0f : std::numeric_limits<float>::infinity(), std::memory_order_relaxed);
  const auto lookOn = [&](std::uint32_t v, std::vector<std::uint32_t>& found) {
    waits[v].store(false);
    const float walked = reached[v].load();
    forNeighbours(mesh.triangles, v, [&](std::uint32_t w) {
      float before = reached[w].load();
      if (walked >= before)
        return;
      const float there = walked + static_cast<float>(edgeLength(mesh, v, w));
      while (there < before && !reached[w].compare_exchange_weak(before, there))
        ;
      if (there < before && there < static_cast<float>(reach) && !waits[w].exchange(true))
        found.push_back(w);
    });
  };
  for (std::vector<std::uint32_t> front = outermost(mesh.triangles, from), next; !front.empty(); front.swap(next), next.clear()) {
    const auto count = static_cast<std::int64_t>(front.size());
#pragma omp parallel
    {
      std::vector<std::uint32_t> found;
#pragma omp for schedule(dynamic, 256) nowait
      for (std::int64_t i = 0; i < count; ++i)
        lookOn(front[i], found);
#pragma omp critical(pcl_spiral_edge_walk)
      next.insert(next.end(), found.begin(), found.end());
    }
  }
  std::vector<float> walked(size);
#pragma omp parallel for schedule(static)
  for (std::int64_t v = 0; v < size; ++v)
    walked[v] = reached[v].load(std::memory_order_relaxed);
  return walked;
}

} // namespace pcl_spiral
