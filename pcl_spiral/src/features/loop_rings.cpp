// SPDX-License-Identifier: BSD-3-Clause
#include "loop_rings.h"

#include <pcl_spiral/core/impl/angles.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace pcl_spiral {

std::vector<Ring>
simpleRings(const Ring& run)
{
  std::vector<Ring> rings;
  Ring open;
  std::unordered_map<std::uint32_t, std::size_t> place; // in open
  for (const std::uint32_t v : run) {
    const auto found = place.find(v);
    if (found != place.end()) {
      const std::size_t from = found->second;
      rings.emplace_back(open.begin() + static_cast<std::ptrdiff_t>(from), open.end());
      for (std::size_t i = from; i < open.size(); ++i)
        place.erase(open[i]);
      open.resize(from);
    }
    place[v] = open.size();
    open.push_back(v);
  }
  rings.push_back(std::move(open));
  return rings;
}

std::vector<Ring>
boundaryRings(const Triangulation& mesh, const std::vector<std::uint32_t>& parts, std::uint32_t which)
{
  std::vector<Ring> rings;
  for (const auto& loop : mesh.boundaryLoops()) {
    if (parts[loop.front() / 3] != which)
      continue;
    Ring run(loop.size());
    for (std::size_t i = 0; i < loop.size(); ++i)
      run[i] = mesh.origin(loop[i]);
    for (Ring& ring : simpleRings(run))
      if (ring.size() > 2)
        rings.push_back(std::move(ring));
  }
  return rings;
}

double
ringLength(const SurfaceGraph& graph, const Ring& ring)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    sum += (graph.position(ring[i]) - graph.position(ring[(i + 1) % ring.size()])).norm();
  return sum;
}

double
ringArea(const SurfaceGraph& graph, const Ring& ring)
{
  const Eigen::Vector3d origin = graph.position(ring[0]);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 1; i + 1 < ring.size(); ++i)
    sum += (graph.position(ring[i]) - origin).cross(graph.position(ring[i + 1]) - origin);
  return 0.5 * sum.norm();
}

bool
isFlaw(const SurfaceGraph& graph, const Ring& ring, double shortest)
{
  return ringLength(graph, ring) < shortest || ringArea(graph, ring) < shortest * shortest / (4.0 * pi);
}

Ring
begunFarOut(const SurfaceGraph& graph, Ring ring)
{
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const std::uint32_t v : ring)
    mean += graph.position(v) / static_cast<double>(ring.size());
  std::size_t first = 0;
  double farthest = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const double distance = (graph.position(ring[i]) - mean).norm();
    if (distance > farthest) {
      farthest = distance;
      first = i;
    }
  }
  std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(first), ring.end());
  return ring;
}

} // namespace pcl_spiral
