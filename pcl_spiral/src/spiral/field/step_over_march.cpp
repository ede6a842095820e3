// SPDX-License-Identifier: BSD-3-Clause
#include "step_over_march.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double worth_a_step = 1e-7;         // a smaller gain does not count as a shorter way
constexpr std::size_t visits_a_report = 4096; // from one report of the progress to the next

using Sides = std::array<float, 3>;

std::vector<Sides>
allSides(const StepOverMesh& mesh)
{
  const auto count = static_cast<std::int64_t>(mesh.triangles.triangleCount());
  std::vector<Sides> sides(mesh.triangles.triangleCount());
#pragma omp parallel for schedule(static, 4096)
  for (std::int64_t t = 0; t < count; ++t) {
    const std::array<double, 3> s = stepOverSides(mesh, t);
    sides[t] = {static_cast<float>(s[0]), static_cast<float>(s[1]), static_cast<float>(s[2])};
  }
  return sides;
}

/** Least distance at a corner over the side that faces it: from the ends of the side, with distances \p di and \p dq, or by a straight
 *  front between them. \p ij, \p qj: from the ends to the corner; \p iq: the side. */
double
acrossTriangle(double di, double dq, double ij, double qj, double iq)
{
  double best = di + ij;
  const double slope = (dq - di) / iq;
  if (!(std::abs(slope) < 1.0))
    return best;
  const double x = (ij * ij + iq * iq - qj * qj) / (2.0 * iq);
  const double y = std::sqrt(std::max(0.0, ij * ij - x * x));
  const double rise = std::sqrt(1.0 - slope * slope);
  const double from = x - slope * y / rise;
  if (from > 0.0 && from < iq)
    best = std::min(best, di + slope * from + y / rise);
  return best;
}

/** The least gain that counts at a node with so many visits. It doubles with each: in thin triangles, nodes correct each other by ever
 *  less, thousands of times. So a node has at most 24 visits for gains up to a step-over, and one more for each doubling of these. */
double
worthAgain(std::uint8_t visits)
{
  return std::ldexp(worth_a_step, visits);
}

} // namespace

std::array<double, 3>
stepOverSides(const StepOverMesh& mesh, std::size_t triangle)
{
  const auto& t = mesh.triangles.triangle(triangle);
  StepOverMetric metric = mesh.metric[t[0]];
  metric += mesh.metric[t[1]];
  metric += mesh.metric[t[2]];
  std::array<double, 3> sides;
  for (int i = 0; i < 3; ++i)
    sides[i] = std::sqrt(std::max(1e-24, metric.squaredLength(mesh.positions[t[(i + 2) % 3]] - mesh.positions[t[(i + 1) % 3]]) / 3.0));
  return sides;
}

std::vector<double>
distancesFromRims(const StepOverMesh& mesh, const std::vector<double>& starts, const std::function<bool(double)>& progress)
{
  using Entry = std::pair<double, std::uint32_t>;
  const std::vector<Sides> sides = allSides(mesh);
  const Triangulation& mesh_t = mesh.triangles;
  std::vector<double> distance(mesh.size(), std::numeric_limits<double>::infinity());
  std::vector<std::uint8_t> visits(mesh.size(), 0);
  std::size_t reached_nodes = 0, all_visits = 0;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
  for (std::size_t r = 0; r < mesh.rims.size(); ++r)
    for (const std::uint32_t v : mesh.rims[r]) {
      distance[v] = starts.empty() ? 0.0 : starts[r];
      if (std::isfinite(distance[v]))
        front.push({distance[v], v});
    }
  while (!front.empty()) {
    const auto [d, i] = front.top();
    front.pop();
    if (d > distance[i])
      continue;
    reached_nodes += visits[i]++ == 0;
    if (++all_visits % visits_a_report == 0 && progress && !progress(static_cast<double>(reached_nodes) / static_cast<double>(mesh.size())))
      return {};
    for (std::size_t o = mesh_t.outgoingBegin(i); o < mesh_t.outgoingBegin(i + 1); ++o) {
      const std::uint32_t h = mesh_t.outgoing(o);
      const std::size_t t = h / 3, ci = h % 3;
      for (std::size_t step = 1; step < 3; ++step) {
        const std::size_t cj = (ci + step) % 3, cq = 3 - ci - cj;
        const std::uint32_t j = mesh_t.triangle(t)[cj], q = mesh_t.triangle(t)[cq];
        const double ij = sides[t][cq], qj = sides[t][ci], iq = sides[t][cj];
        const double reached = std::isfinite(distance[q]) ? acrossTriangle(d, distance[q], ij, qj, iq) : d + ij;
        if (reached < distance[j] - worthAgain(visits[j])) {
          distance[j] = reached;
          front.push({reached, j});
        }
      }
    }
  }
  return distance;
}

std::vector<float>
gradientLengths(const StepOverMesh& mesh, const std::vector<double>& distance)
{
  const auto count = static_cast<std::int64_t>(mesh.triangles.triangleCount());
  std::vector<float> lengths(mesh.triangles.triangleCount());
#pragma omp parallel for schedule(static, 4096)
  for (std::int64_t i = 0; i < count; ++i) {
    const auto& t = mesh.triangles.triangle(i);
    const auto [c, b, a] = stepOverSides(mesh, i);
    const double x = (a * a + b * b - c * c) / (2.0 * a), y = std::sqrt(std::max(1e-12, b * b - x * x));
    const double along = (distance[t[1]] - distance[t[0]]) / a;
    const double across = (distance[t[2]] - distance[t[0]] - along * x) / y;
    lengths[i] = static_cast<float>(std::hypot(along, across));
  }
  return lengths;
}

std::vector<float>
gradientAgreement(const StepOverMesh& mesh, const std::vector<double>& distance)
{
  const Triangulation& triangles = mesh.triangles;
  std::vector<Eigen::Vector3f> gradient(triangles.triangleCount());
  const auto triangle_count = static_cast<std::int64_t>(triangles.triangleCount());
#pragma omp parallel for schedule(static, 4096)
  for (std::int64_t i = 0; i < triangle_count; ++i) {
    const auto& t = triangles.triangle(i);
    const Eigen::Vector3d e1 = mesh.positions[t[1]] - mesh.positions[t[0]], e2 = mesh.positions[t[2]] - mesh.positions[t[0]];
    const Eigen::Vector3d n = e1.cross(e2);
    const Eigen::Vector3d g = (distance[t[1]] - distance[t[0]]) * e2.cross(n) + (distance[t[2]] - distance[t[0]]) * n.cross(e1);
    gradient[i] = g.normalized().cast<float>();
  }
  std::vector<float> agreement(mesh.size());
  const auto count = static_cast<std::int64_t>(mesh.size());
#pragma omp parallel for schedule(static, 4096)
  for (std::int64_t v = 0; v < count; ++v) {
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    const std::size_t begin = triangles.outgoingBegin(v), end = triangles.outgoingBegin(v + 1);
    for (std::size_t i = begin; i < end; ++i)
      sum += gradient[triangles.outgoing(i) / 3];
    agreement[v] = end > begin ? sum.norm() / static_cast<float>(end - begin) : 1.0f;
  }
  return agreement;
}

} // namespace pcl_spiral
