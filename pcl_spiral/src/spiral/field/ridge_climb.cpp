// SPDX-License-Identifier: BSD-3-Clause
#include "ridge_climb.h"

#include <algorithm>
#include <queue>
#include <unordered_map>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double noise_reach = 0.8; // step-overs within which a summit may come from noise

} // namespace

RidgeClimb::RidgeClimb(const StepOverDistance& field) : up_(field.mesh.size(), none), summit_(field.mesh.size(), none)
{
  const auto count = static_cast<std::int64_t>(field.mesh.size());
#pragma omp parallel for schedule(dynamic, 4096)
  for (std::int64_t i = 0; i < count; ++i) {
    const auto v = static_cast<std::uint32_t>(i);
    double steepest = 0.0;
    forNeighbours(field.mesh.triangles, v, [&](std::uint32_t w) {
      const double rise = field.distance[w] - field.distance[v];
      if (rise <= 0.0)
        return;
      const double slope = rise / edgeLength(field.mesh, v, w);
      if (slope > steepest || (slope == steepest && w < up_[v])) {
        steepest = slope;
        up_[v] = w;
      }
    });
    if (up_[v] == none)
      up_[v] = higherNode(field, v);
  }
  findSummits();
}

void
RidgeClimb::findSummits()
{
  const auto count = static_cast<std::int64_t>(up_.size());
#pragma omp parallel
  {
    std::vector<std::uint32_t> way; // other threads may write the same summits
#pragma omp for schedule(dynamic, 4096)
    for (std::int64_t v = 0; v < count; ++v) {
      std::uint32_t at = static_cast<std::uint32_t>(v), top = none;
      for (way.clear(); top == none; at = up_[at]) {
#pragma omp atomic read
        top = summit_[at];
        if (top != none)
          break;
        way.push_back(at);
        if (up_[at] == none)
          top = at;
      }
      for (const std::uint32_t w : way) {
#pragma omp atomic write
        summit_[w] = top;
      }
    }
  }
}

std::uint32_t
RidgeClimb::higherNode(const StepOverDistance& field, std::uint32_t v) const
{
  using Entry = std::pair<double, std::uint32_t>;
  std::unordered_map<std::uint32_t, double> reached{{v, 0.0}};
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
  front.push({0.0, v});
  std::uint32_t best = none;
  while (!front.empty()) {
    const double d = front.top().first; // clang 14 has no captures of structured bindings
    const std::uint32_t i = front.top().second;
    front.pop();
    if (d > reached[i])
      continue;
    if (field.distance[i] > field.distance[v] + 1e-9 &&
        (best == none || field.distance[i] > field.distance[best] || (field.distance[i] == field.distance[best] && i < best)))
      best = i;
    forNeighbours(field.mesh.triangles, i, [&](std::uint32_t w) {
      const double there = d + edgeLength(field.mesh, i, w);
      const auto known = reached.find(w);
      if (there < noise_reach && (known == reached.end() || there < known->second)) {
        reached[w] = there;
        front.push({there, w});
      }
    });
  }
  return best;
}

} // namespace pcl_spiral
