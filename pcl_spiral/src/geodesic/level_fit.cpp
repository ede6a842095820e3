// SPDX-License-Identifier: BSD-3-Clause
#include "level_fit.h"

#include <pcl_spiral/core/impl/frame.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace pcl_spiral {
namespace {

constexpr std::size_t fewest_points = 18;
constexpr double bending = 1e-2; // determines the second order where the points do not

struct Value {
  std::uint32_t point;
  double level; ///< relative to the value at the start
};

/** Points within \p reach of \p query that are joined to \p start by such points. */
std::vector<Value>
valuesNear(const SurfaceGraph& graph, std::uint32_t start, const Eigen::Vector3d& query, double reach,
           const std::function<double(std::uint32_t)>& growth)
{
  const Triangulation& mesh = graph.triangulation();
  std::vector<Value> found{{start, 0.0}};
  std::unordered_map<std::uint32_t, bool> seen{{start, true}};
  for (std::size_t at = 0; at < found.size(); ++at)
    for (std::uint32_t k = mesh.outgoingBegin(found[at].point); k < mesh.outgoingBegin(found[at].point + 1); ++k) {
      // On the boundary a point is the target of one half-edge it is not the origin of.
      for (const std::uint32_t h : {mesh.outgoing(k), Triangulation::previous(mesh.outgoing(k))}) {
        const bool forward = mesh.origin(h) == found[at].point;
        const std::uint32_t v = forward ? mesh.target(h) : mesh.origin(h);
        if ((graph.position(v) - query).norm() < reach && seen.emplace(v, true).second)
          found.push_back({v, found[at].level + (forward ? growth(h) : -growth(h))});
      }
    }
  return found;
}

} // namespace

double
fitLevel(const SurfaceGraph& graph, std::uint32_t start, const Eigen::Vector3d& query, const std::function<double(std::uint32_t)>& growth)
{
  double reach = 5.0 * graph.spacing();
  std::vector<Value> values;
  for (int widening = 0; widening < 6; ++widening, reach *= 1.5) {
    values = valuesNear(graph, start, query, reach, growth);
    if (values.size() >= fewest_points)
      break;
  }
  Eigen::Vector3d e1, e2;
  tangentFrame(graph.normal(start), e1, e2);
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
  Vector6 right = Vector6::Zero();
  for (const Value& value : values) {
    const Eigen::Vector3d d = (graph.position(value.point) - query) / reach;
    const double x = d.dot(e1), y = d.dot(e2), near = std::max(0.0, 1.0 - d.squaredNorm());
    const double w = near * near * near;
    Vector6 row;
    row << 1.0, x, y, x * x + y * y, x * x - y * y, 2.0 * x * y; // the same fit in any frame
    normal += w * row * row.transpose();
    right += w * value.level * row;
  }
  for (int i = 1; i < 6; ++i)
    normal(i, i) += (i < 3 ? 1e-9 : bending) * normal(0, 0);
  const double level = normal.ldlt().solve(right)[0];
  return std::isfinite(level) ? level : 0.0;
}

std::vector<double>
growing(const std::vector<double>& levels, double period)
{
  struct Pool {
    double sum;
    std::size_t count;
  };
  // Three periods, so that no end affects the middle one.
  const std::size_t n = levels.size();
  std::vector<Pool> pools;
  for (std::size_t i = 0; i < 3 * n; ++i) {
    const std::size_t turn = i / n;
    pools.push_back({levels[i % n] + period * static_cast<double>(turn), 1});
    while (pools.size() > 1) {
      Pool &last = pools.back(), &before = pools[pools.size() - 2];
      if (before.sum * static_cast<double>(last.count) <= last.sum * static_cast<double>(before.count))
        break;
      before.sum += last.sum;
      before.count += last.count;
      pools.pop_back();
    }
  }
  std::vector<double> all;
  for (const Pool& pool : pools)
    all.insert(all.end(), pool.count, pool.sum / static_cast<double>(pool.count));
  std::vector<double> result(all.begin() + n, all.begin() + 2 * n);
  result.push_back(result.front() + period);
  return result;
}

} // namespace pcl_spiral
