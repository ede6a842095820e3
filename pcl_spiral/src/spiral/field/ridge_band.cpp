// SPDX-License-Identifier: BSD-3-Clause
#include "ridge_band.h"

#include "ridge_climb.h"

#include <algorithm>
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
      if (field_.is_searched[v])
        visit(v, static_cast<std::size_t>(field_.distance[v]));
  };
  forNodes([this](std::uint32_t, std::size_t level) { ++begin_[level + 1]; });
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  nodes_.resize(begin_.back());
  std::vector<std::size_t> next(begin_);
  forNodes([&](std::uint32_t v, std::size_t level) { nodes_[next[level]++] = v; });
}

void
RidgeBand::findNear()
{
  is_near_ = field_.is_searched;
  std::vector<float> reached(field_.mesh.size(), std::numeric_limits<float>::infinity());
  std::vector<std::uint32_t> queue; // a node again when a shorter way to it is found, but once at a time
  std::vector<std::uint8_t> waits(field_.mesh.size(), 0);
  std::vector<std::uint8_t> starts(nodes_.size(), 0);
  const auto count = static_cast<std::int64_t>(nodes_.size());
#pragma omp parallel for schedule(static, 4096)
  for (std::int64_t i = 0; i < count; ++i)
    forNeighbours(field_.mesh.triangles, nodes_[i], [&](std::uint32_t w) { starts[i] = starts[i] || !field_.is_searched[w]; });
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    if (starts[i]) {
      reached[nodes_[i]] = 0.0f;
      queue.push_back(nodes_[i]);
    }
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const std::uint32_t v = queue[i];
    const float walked = reached[v];
    waits[v] = 0;
    forNeighbours(field_.mesh.triangles, v, [&](std::uint32_t w) {
      if (field_.is_searched[w] || walked >= reached[w])
        return;
      const float there = walked + static_cast<float>(edgeLength(field_.mesh, v, w));
      if (there >= reached[w])
        return;
      reached[w] = there;
      is_near_[w] = 1; // the first beyond the reach too: it ends an edge that begins within
      if (there < near_band && !waits[w]) {
        waits[w] = 1;
        queue.push_back(w);
      }
    });
  }
}

void
RidgeBand::findAbout()
{
  std::vector<std::uint8_t> is_about(field_.mesh.size(), 0);
  spread(field_.mesh.triangles, field_.is_searched, is_about);
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
