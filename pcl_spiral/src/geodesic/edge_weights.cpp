// SPDX-License-Identifier: BSD-3-Clause
#include "edge_weights.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>

namespace pcl_spiral {
namespace {

constexpr double least_weight = 1e-5;
constexpr double largest_cotangent = 1e4;

/** Cotangents of a triangle's angles, each at the index of the half-edge opposite to it. */
std::array<double, 3>
cotangents(const SurfaceGraph& graph, std::uint32_t t)
{
  const auto& corner = graph.triangulation().triangle(t);
  const std::array<Eigen::Vector3d, 3> p{graph.position(corner[0]), graph.position(corner[1]), graph.position(corner[2])};
  const double area = std::max((p[1] - p[0]).cross(p[2] - p[0]).norm(), 1e-300); // twice the triangle's
  std::array<double, 3> cotangent{};
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d &c = p[(i + 2) % 3], &a = p[i], &b = p[(i + 1) % 3];
    cotangent[i] = std::clamp((a - c).dot(b - c) / area, -largest_cotangent, largest_cotangent);
  }
  return cotangent;
}

/** Leave out the slivers along the boundary, from outside inwards: their circumcentres, and so the dual edges, lie
 *  outside the surface. */
void
peel(const Triangulation& mesh, std::vector<double>& cotangent)
{
  std::vector<std::uint8_t> left_out(mesh.triangleCount(), 0);
  const auto isOuter = [&](std::uint32_t h) { return mesh.opposite(h) == Triangulation::none || left_out[mesh.opposite(h) / 3]; };
  std::vector<std::uint32_t> open;
  for (std::uint32_t h = 0; h < mesh.halfEdgeCount(); ++h)
    if (mesh.opposite(h) == Triangulation::none)
      open.push_back(h);
  while (!open.empty()) {
    const std::uint32_t h = open.back(), t = h / 3;
    open.pop_back();
    if (left_out[t] || !isOuter(h) || cotangent[h] >= 0.0)
      continue;
    left_out[t] = 1;
    const std::uint32_t after = Triangulation::next(h), before = Triangulation::previous(h);
    // The angle at an end of h is opposite to the side that leaves from its other end.
    const double at_origin = cotangent[after], at_target = cotangent[before];
    cotangent[h] = 0.0;
    cotangent[after] = 1.0 / std::max(at_target, 1.0 / largest_cotangent);
    cotangent[before] = 1.0 / std::max(at_origin, 1.0 / largest_cotangent);
    for (const std::uint32_t side : {after, before})
      if (mesh.opposite(side) != Triangulation::none)
        open.push_back(mesh.opposite(side));
  }
}

} // namespace

std::vector<double>
edgeWeights(const SurfaceGraph& graph)
{
  const Triangulation& mesh = graph.triangulation();
  std::vector<double> cotangent(mesh.halfEdgeCount()), whole(mesh.halfEdgeCount());
  const auto triangles = static_cast<std::int64_t>(mesh.triangleCount());
#pragma omp parallel for schedule(static)
  for (std::int64_t t = 0; t < triangles; ++t) {
    const auto own = cotangents(graph, static_cast<std::uint32_t>(t));
    std::copy(own.begin(), own.end(), cotangent.begin() + 3 * t);
  }
  peel(mesh, cotangent);
  const auto half_edges = static_cast<std::int64_t>(mesh.halfEdgeCount());
#pragma omp parallel for schedule(static)
  for (std::int64_t h = 0; h < half_edges; ++h) {
    const std::uint32_t twin = mesh.opposite(static_cast<std::uint32_t>(h));
    whole[h] = std::max(least_weight, 0.5 * (cotangent[h] + (twin == Triangulation::none ? 0.0 : cotangent[twin])));
  }
  return whole;
}

} // namespace pcl_spiral
