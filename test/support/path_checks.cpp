// SPDX-License-Identifier: BSD-3-Clause
#include "support/path_checks.h"

#include <pcl_spiral/core/impl/angles.h>

#include "support/move_tree.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

#include <omp.h>

namespace pcl_spiral::test {

namespace {

Place
placeAt(const AnalyticSurface& surface, const CheckedPath& path, std::size_t i, double value)
{
  return {value, path.contacts[i], surface.rimDistance(surface.pulled(path.contacts[i])), path.turn(i), i};
}

double
angle(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return in_degrees * std::atan2(a.cross(b).norm(), a.dot(b));
}

/** Index of the entry of largest magnitude. */
std::size_t
largest(const std::vector<double>& values)
{
  return static_cast<std::size_t>(
      std::max_element(values.begin(), values.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }) - values.begin());
}

void
measureDeviation(const AnalyticSurface& surface, const CheckedPath& path, int threads, ToolpathReport& f)
{
  const auto n = static_cast<std::ptrdiff_t>(path.size());
  std::vector<double> distance(path.size()), normal(path.size()), beyond(path.size(), 0.0);
#pragma omp parallel for schedule(dynamic, 512) num_threads(threads)
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const Eigen::Vector3d x = surface.closest(path.contacts[at]), n_exact = surface.normal(x);
    distance[at] = (path.contacts[at] - x).dot(n_exact);
    normal[at] = angle(path.normals[at], n_exact);
    if (!surface.contains(x))
      beyond[at] = surface.rimDistance(x);
  }
  f.deviation = placeAt(surface, path, largest(distance), distance[largest(distance)]);
  f.normal_error = placeAt(surface, path, largest(normal), normal[largest(normal)]);
  f.beyond_rim = placeAt(surface, path, largest(beyond), beyond[largest(beyond)]);
  double sum = 0.0;
  for (double& d : distance) {
    sum += d * d;
    d = std::abs(d);
  }
  f.deviation_rms = std::sqrt(sum / static_cast<double>(path.size()));
  f.deviation_p99 = quantile(distance, 0.99);
}

void
measureMoves(const AnalyticSurface& surface, const CheckedPath& path, double clear, ToolpathReport& f)
{
  std::vector<double> s(path.size(), 0.0);
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double gap = (path.contacts[i] - path.contacts[i - 1]).norm();
    s[i] = s[i - 1] + gap;
    if (gap > f.gap.value)
      f.gap = placeAt(surface, path, i - 1, gap);
  }
  f.length = s.back();
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    const Eigen::Vector3d a = path.contacts[i] - path.contacts[i - 1];
    const Eigen::Vector3d b = path.contacts[i + 1] - path.contacts[i];
    const double turn = angle(a, b);
    const bool near_end =
        (path.contacts[i] - path.contacts.front()).norm() < clear || (path.contacts[i] - path.contacts.back()).norm() < clear;
    if (turn <= f.turning.value || near_end)
      continue;
    const Place place = placeAt(surface, path, i, turn);
    if (place.rim >= clear)
      f.turning = place;
  }
}

void
measureRim(const AnalyticSurface& surface, const CheckedPath& path, ToolpathReport& f)
{
  const MoveTree tree(path.contacts);
  for (const Polyline& loop : surface.outlines())
    for (const Eigen::Vector3d& x : loop) {
      const auto [distance, move] = tree.nearest(x);
      if (distance > f.rim_missed.value)
        f.rim_missed = {distance, x, 0.0, path.turn(move), move};
    }
}

/** How far each of two moves goes beyond the other, the smaller of the two; negative if they do not cross. */
double
crossingDepth(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c, const Eigen::Vector2d& d)
{
  const auto side = [](const Eigen::Vector2d& from, const Eigen::Vector2d& to, const Eigen::Vector2d& p) {
    const Eigen::Vector2d e = to - from, q = p - from;
    return (e.x() * q.y() - e.y() * q.x()) / std::max(e.norm(), 1e-300);
  };
  const double sa = side(c, d, a), sb = side(c, d, b), sc = side(a, b, c), sd = side(a, b, d);
  if (sa * sb >= 0.0 || sc * sd >= 0.0)
    return -1.0;
  return std::min({std::abs(sa), std::abs(sb), std::abs(sc), std::abs(sd)});
}

} // namespace

std::vector<Place>
crossings(const AnalyticSurface& surface, const CheckedPath& path, double tolerance, int threads)
{
  if (path.size() < 4)
    return {};
  std::vector<Eigen::Vector3d> plane(path.size());
  for (std::size_t i = 0; i < path.size(); ++i)
    plane[i] << surface.chart(path.contacts[i]), 0.0;
  const MoveTree tree(plane);
  const int count = threads > 0 ? threads : omp_get_max_threads();
  std::vector<Place> found;
#pragma omp parallel for schedule(dynamic, 512) num_threads(count)
  for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(tree.moves()); ++i) {
    const auto at = static_cast<std::size_t>(i);
    tree.laterOverlaps(at, [&](std::size_t j) {
      const double depth = crossingDepth(plane[at].head<2>(), plane[at + 1].head<2>(), plane[j].head<2>(), plane[j + 1].head<2>());
      if (depth > tolerance) {
        const Place place = placeAt(surface, path, at, depth);
#pragma omp critical
        found.push_back(place);
      }
    });
  }
  std::sort(found.begin(), found.end(),
            [](const Place& a, const Place& b) { return a.value != b.value ? a.value > b.value : a.index < b.index; });
  return found;
}

ToolpathReport
checkPath(const AnalyticSurface& surface, const CheckedPath& path, double clear, int threads)
{
  ToolpathReport f;
  if (path.size() < 2)
    return f;
  const int count = threads > 0 ? threads : omp_get_max_threads();
  measureDeviation(surface, path, count, f);
  measureMoves(surface, path, clear, f);
  measureRim(surface, path, f);
  const std::vector<Place> crossed = crossings(surface, path, 0.01, count);
  f.crossings = crossed.size();
  if (!crossed.empty())
    f.crossing = crossed.front();
  return f;
}

} // namespace pcl_spiral::test
