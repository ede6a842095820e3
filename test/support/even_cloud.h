// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Clouds as even as a thinned scan. Lengths in mm.
 */
#pragma once

#include "support/sampling.h"

#include <pcl_spiral/graph/impl/surface_graph.h>

#include <cmath>
#include <map>
#include <stdexcept>
#include <tuple>
#include <vector>

namespace pcl_spiral::test {

/** Random points of \p surface, each farther than \p apart from the points kept before; \p tries for each point that
 * fits side by side. */
inline std::vector<Eigen::Vector3d>
evenPoints(const AnalyticSurface& surface, double apart, double tries, std::uint64_t seed)
{
  using Cell = std::tuple<long, long, long>;
  std::map<Cell, std::vector<Eigen::Vector3d>> cells;
  std::vector<Eigen::Vector3d> kept;
  const auto count = static_cast<std::size_t>(tries * surface.area() / (apart * apart));
  for (const Eigen::Vector3d& p : sampleUniform(surface, count, seed).points) {
    const auto cell = [&](int d) { return std::lround(std::floor(p[d] / apart)); };
    bool free = true;
    for (int k = 0; k < 27 && free; ++k) {
      const auto near = cells.find({cell(0) + k % 3 - 1, cell(1) + k / 3 % 3 - 1, cell(2) + k / 9 - 1});
      for (std::size_t i = 0; near != cells.end() && i < near->second.size(); ++i)
        free = free && (near->second[i] - p).norm() > apart;
    }
    if (!free)
      continue;
    cells[{cell(0), cell(1), cell(2)}].push_back(p);
    kept.push_back(p);
  }
  return kept;
}

/** The graph of points, with normals on the whole towards +z. */
inline SurfaceGraph
graphOf(const std::vector<Eigen::Vector3d>& points)
{
  std::vector<Eigen::Vector3f> rounded;
  for (const Eigen::Vector3d& p : points)
    rounded.push_back(p.cast<float>());
  SurfaceGraph graph;
  if (const Status status = graph.build(std::move(rounded), {}); !status.ok())
    throw std::runtime_error(status.message());
  return graph;
}

} // namespace pcl_spiral::test
