// SPDX-License-Identifier: BSD-3-Clause
#include "start_lines.h"

#include <limits>

namespace pcl_spiral {
namespace {

constexpr std::size_t fewest_coarse_points = 20000; // of a coarse graph, so that it is finer than the stations of the lines

/** The graph of the point nearest to the middle of each block, with the normals of \p graph; null if none is made. */
std::shared_ptr<const SurfaceGraph>
coarseGraph(const SurfaceGraph& graph)
{
  const PointBlocks& blocks = graph.blocks();
  const std::size_t count = blocks.blockCount();
  if (count < fewest_coarse_points)
    return nullptr;
  std::vector<Eigen::Vector3f> points(count);
  SurfaceGraphOptions options;
  options.given_normals.resize(count);
#pragma omp parallel for schedule(static)
  for (std::int64_t b = 0; b < static_cast<std::int64_t>(count); ++b) {
    Eigen::Vector3f middle = Eigen::Vector3f::Zero();
    for (std::size_t i = blocks.blockBegin(b); i < blocks.blockEnd(b); ++i)
      middle += blocks.point(i);
    middle /= static_cast<float>(blocks.blockEnd(b) - blocks.blockBegin(b));
    std::size_t best = blocks.blockBegin(b);
    for (std::size_t i = best; i < blocks.blockEnd(b); ++i)
      if ((blocks.point(i) - middle).squaredNorm() < (blocks.point(best) - middle).squaredNorm())
        best = i;
    points[b] = blocks.point(best);
    options.given_normals[b] = graph.normals()[best];
  }
  auto coarse = std::make_shared<SurfaceGraph>();
  return coarse->build(points, options).ok() ? coarse : nullptr;
}

} // namespace

StartLines::StartLines(const SurfaceGraph& graph) : graph_(&graph), coarse_(coarseGraph(graph)) {}

double
StartLines::spacing() const
{
  return coarse_ ? coarse_->spacing() : graph_->spacing();
}

bool
StartLines::setCentre(const Eigen::Vector3d& centre)
{
  centre_ = centre;
  if (coarse_ && field_.compute(*coarse_, centre))
    return true;
  coarse_ = nullptr;
  return field_.compute(*graph_, centre);
}

void
StartLines::useEveryPoint()
{
  coarse_ = nullptr;
  field_ = DistanceField();
}

Polyline
StartLines::between(const Eigen::Vector3d& from, const Eigen::Vector3d& place) const
{
  Polyline line = field_.trace(place);
  if (line.size() < 2)
    return {};
  // Straight from the start to a place well away from the field's centre.
  const double clear = 2.0 * (from - centre_).norm();
  std::size_t first = 1;
  while (first + 1 < line.size() && (line[first] - centre_).norm() < clear)
    ++first;
  line.erase(line.begin() + 1, line.begin() + static_cast<std::ptrdiff_t>(first));
  line.front() = from;
  line.back() = place;
  return line;
}

} // namespace pcl_spiral
