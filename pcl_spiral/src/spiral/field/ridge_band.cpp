// SPDX-License-Identifier: BSD-3-Clause
#include "ridge_band.h"

#include "edge_walk.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double near_band = 1.5; // step-overs

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

/** Nodes within reach of the band, and the first beyond on each way: it ends an edge that begins within. */
void
RidgeBand::findNear()
{
  const std::vector<float> walked = walkedFrom(field_.mesh, field_.is_fine, near_band);
  is_near_.resize(walked.size());
  std::transform(walked.begin(), walked.end(), is_near_.begin(), [](float w) -> std::uint8_t { return std::isfinite(w); });
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
