// SPDX-License-Identifier: BSD-3-Clause
#include "ridge_band.h"

#include "ridge_climb.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr float near_band = 1.5f; // step-overs

/** Mark the corners of every triangle that has a corner marked in \p before. */
void
spread(const Triangulation& triangles, const std::vector<std::uint8_t>& before, std::vector<std::uint8_t>& marked)
{
  for (std::size_t i = 0; i < triangles.triangleCount(); ++i) {
    const auto& c = triangles.triangle(i);
    if (before[c[0]] || before[c[1]] || before[c[2]])
      for (const std::uint32_t v : c)
        marked[v] = 1;
  }
}

} // namespace

RidgeBand::RidgeBand(const StepOverDistance& field) : field_(field), begin_(static_cast<std::size_t>(field.largest) + 2, 0)
{
  sortNodes();
  findNear();
  findAbout();
}

void
RidgeBand::sortNodes()
{
  const auto forNodes = [this](const auto& visit) {
    for (std::uint32_t v = 0; v < field_.mesh.size(); ++v)
      if (field_.is_fine[v])
        visit(v, static_cast<std::size_t>(field_.distance[v]));
  };
  forNodes([this](std::uint32_t, std::size_t level) { ++begin_[level + 1]; });
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  nodes_.resize(begin_.back());
  std::vector<std::size_t> next(begin_);
  forNodes([&](std::uint32_t v, std::size_t level) { nodes_[next[level]++] = v; });
}

/** Nodes of the band with neighbours outside. */
std::vector<std::uint32_t>
RidgeBand::outermost() const
{
  std::vector<std::uint8_t> is_outermost(nodes_.size(), 0);
  const auto count = static_cast<std::int64_t>(nodes_.size());
#pragma omp parallel for schedule(static, 4096)
  for (std::int64_t i = 0; i < count; ++i)
    forNeighbours(field_.mesh.triangles, nodes_[i], [&](std::uint32_t w) { is_outermost[i] = is_outermost[i] || !field_.is_fine[w]; });
  std::vector<std::uint32_t> found;
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    if (is_outermost[i])
      found.push_back(nodes_[i]);
  return found;
}

/** Shortest ways along edges from the band, in rounds: all nodes with a new way look at their neighbours in parallel. The order, and who
 *  finds a way first, do not matter: a node is in the next round when a shorter way to it is found, and the shortest remains. */
void
RidgeBand::findNear()
{
  const auto size = static_cast<std::int64_t>(field_.mesh.size());
  std::vector<std::atomic<float>> reached(size);
  std::vector<std::atomic<bool>> waits(size);
#pragma omp parallel for schedule(static)
  for (std::int64_t v = 0; v < size; ++v)
    reached[v].store(field_.is_fine[v] ? 0.0f : std::numeric_limits<float>::infinity(), std::memory_order_relaxed);
  const auto lookOn = [&](std::uint32_t v, std::vector<std::uint32_t>& found) {
    waits[v].store(false);
    const float walked = reached[v].load();
    forNeighbours(field_.mesh.triangles, v, [&](std::uint32_t w) {
      float before = reached[w].load();
      if (walked >= before)
        return;
      const float there = walked + static_cast<float>(edgeLength(field_.mesh, v, w));
      while (there < before && !reached[w].compare_exchange_weak(before, there))
        ;
      if (there < before && there < near_band && !waits[w].exchange(true))
        found.push_back(w);
    });
  };
  for (std::vector<std::uint32_t> front = outermost(), next; !front.empty(); front.swap(next), next.clear()) {
    const auto count = static_cast<std::int64_t>(front.size());
#pragma omp parallel
    {
      std::vector<std::uint32_t> found;
#pragma omp for schedule(dynamic, 256) nowait
      for (std::int64_t i = 0; i < count; ++i)
        lookOn(front[i], found);
#pragma omp critical(pcl_spiral_ridge_band)
      next.insert(next.end(), found.begin(), found.end());
    }
  }
  is_near_.resize(size); // the first beyond the reach too: it ends an edge that begins within
#pragma omp parallel for schedule(static)
  for (std::int64_t v = 0; v < size; ++v)
    is_near_[v] = std::isfinite(reached[v].load(std::memory_order_relaxed));
}

void
RidgeBand::findAbout()
{
  std::vector<std::uint8_t> is_about(field_.mesh.size(), 0);
  spread(field_.mesh.triangles, field_.is_fine, is_about);
  std::vector<Eigen::Vector3f> points;
  for (std::uint32_t v = 0; v < field_.mesh.size(); ++v)
    if (is_about[v]) {
      about_.push_back(v);
      points.push_back(field_.mesh.positions[v].cast<float>());
    }
  if (!points.empty())
    blocks_ = PointBlocks(std::move(points));
}

std::vector<std::uint32_t>
RidgeBand::between(double low, double high) const
{
  std::vector<std::uint32_t> found;
  const auto end = std::min(begin_.size() - 1, static_cast<std::size_t>(std::ceil(high)));
  for (auto level = static_cast<std::size_t>(low); level < end; ++level) {
    const auto middle = static_cast<std::ptrdiff_t>(found.size());
    std::copy_if(nodes_.begin() + static_cast<std::ptrdiff_t>(begin_[level]),
                 nodes_.begin() + static_cast<std::ptrdiff_t>(begin_[level + 1]), std::back_inserter(found),
                 [&](std::uint32_t v) { return field_.distance[v] >= low && field_.distance[v] < high; });
    std::inplace_merge(found.begin(), found.begin() + middle, found.end());
  }
  return found;
}

} // namespace pcl_spiral
