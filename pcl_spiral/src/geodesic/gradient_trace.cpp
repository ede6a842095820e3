// SPDX-License-Identifier: BSD-3-Clause
#include "distance_field.h"

#include "mesh_walk.h"

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr double arrival = 2.5;      // in spacings: from here, straight to the source
constexpr double kernel_reach = 2.0; // in local spacings, of the gradient's smoothing
constexpr double too_far_off = 0.75; // of that reach, from the nearest point: off the surface
constexpr int patience = 4;          // steps without getting lower

Eigen::Vector3d
nearestOnSegment(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& x)
{
  const Eigen::Vector3d along = b - a;
  const double squared = along.squaredNorm();
  return squared > 0.0 ? Eigen::Vector3d(a + std::min(1.0, std::max(0.0, (x - a).dot(along) / squared)) * along) : a;
}

/** How far from point \p v positions belong to it: up to the farthest neighbour where scan lines are far apart. */
double
reachAbout(const SurfaceGraph& graph, std::uint32_t v)
{
  const Eigen::Vector3d x = graph.position(v);
  double squared = std::pow(kernel_reach * graph.spacing(v), 2);
  forNeighbours(graph.triangulation(), v, [&](std::uint32_t j) { squared = std::max(squared, (graph.position(j) - x).squaredNorm()); });
  return std::sqrt(squared);
}

} // namespace

/** A position on the way, and the reached point of the cloud nearest to it. */
struct DistanceField::Place {
  Eigen::Vector3d x;
  std::uint32_t point;
};

std::uint32_t
DistanceField::nearestReached(const Eigen::Vector3d& x) const
{
  return nearestPoint(*graph_, x, reachOf(*graph_), [&](std::uint32_t i) { return distances_[i] < unreached; });
}

Eigen::Vector3d
DistanceField::sourceNearestTo(const Eigen::Vector3d& x) const
{
  Eigen::Vector3d best = source_[0];
  for (std::size_t i = 0; source_.size() > 1 && i < source_.size(); ++i) {
    const Eigen::Vector3d p = nearestOnSegment(source_[i], source_[(i + 1) % source_.size()], x);
    if ((p - x).squaredNorm() < (best - x).squaredNorm())
      best = p;
  }
  return best;
}

/** Gradient at a place, from the nearest point and its neighbours; walks to the nearest point first. */
Eigen::Vector3d
DistanceField::smoothGradient(Place& place) const
{
  const Triangulation& mesh = graph_->triangulation();
  for (bool moved = true; moved;) {
    moved = false;
    double least = (graph_->position(place.point) - place.x).squaredNorm();
    forNeighbours(mesh, place.point, [&, from = place.point](std::uint32_t j) {
      const double squared = (graph_->position(j) - place.x).squaredNorm();
      if (squared < least && distances_[j] < unreached) {
        least = squared;
        place.point = j;
        moved = from != j;
      }
    });
  }
  const double reach = reachAbout(*graph_, place.point);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  const auto add = [&](std::uint32_t j) {
    const double inside = 1.0 - (graph_->position(j) - place.x).squaredNorm() / (reach * reach);
    if (inside > 0.0)
      sum += inside * inside * gradient(j);
  };
  add(place.point);
  forNeighbours(mesh, place.point, add);
  if (sum.norm() < 0.05)
    sum = gradient(place.point);
  const double norm = sum.norm();
  return norm > 0.0 ? Eigen::Vector3d(sum / norm) : sum;
}

/** One midpoint step downhill; false if it leads off the surface. */
bool
DistanceField::step(Place& place) const
{
  const double length = graph_->spacing();
  Place middle = place;
  const Eigen::Vector3d first = smoothGradient(middle);
  middle.x = place.x - 0.5 * length * first;
  const Eigen::Vector3d second = smoothGradient(middle);
  if (!(second.squaredNorm() > 0.0))
    return false;
  place = {place.x - length * second, middle.point};
  smoothGradient(place);
  const Eigen::Vector3d normal = graph_->normal(place.point);
  place.x -= normal * normal.dot(place.x - graph_->position(place.point));
  return (place.x - graph_->position(place.point)).norm() < too_far_off * reachAbout(*graph_, place.point);
}

std::uint32_t
DistanceField::lowestNeighbour(std::uint32_t v) const
{
  std::uint32_t lowest = v;
  forNeighbours(graph_->triangulation(), v, [&](std::uint32_t j) {
    if (distances_[j] < distances_[lowest])
      lowest = j;
  });
  return lowest;
}

Polyline
DistanceField::trace(const Eigen::Vector3d& to) const
{
  const std::uint32_t start = graph_ && !source_.empty() ? nearestReached(to) : Triangulation::none;
  if (start == Triangulation::none)
    return {};
  Polyline line{to};
  Place place{to, start}, lowest = place;
  std::size_t kept = 1; // points of the line up to the lowest place
  int stalled = 0;
  while (distances_[lowest.point] > arrival * graph_->spacing()) {
    const bool on_surface = step(place);
    if (on_surface) {
      line.push_back(place.x);
      if (distances_[place.point] < distances_[lowest.point]) {
        lowest = place;
        kept = line.size();
        stalled = 0;
        continue;
      }
    }
    if (on_surface && ++stalled < patience)
      continue;
    // The gradient misleads here: go back to the lowest place, then on over the points.
    line.resize(kept);
    const std::uint32_t next = lowestNeighbour(lowest.point);
    if (next == lowest.point)
      break;
    place = lowest = {graph_->position(next), next};
    line.push_back(place.x);
    kept = line.size();
    stalled = 0;
  }
  line.resize(kept);
  const Eigen::Vector3d last = line.back(), source = sourceNearestTo(last);
  const auto pieces = static_cast<int>((source - last).norm() / graph_->spacing());
  for (int i = 1; i < pieces; ++i)
    line.push_back(last + (source - last) * i / pieces);
  if (line.size() > 1 && (line.back() - source).norm() < 1e-9)
    line.pop_back();
  line.push_back(source);
  std::reverse(line.begin(), line.end());
  return line;
}

} // namespace pcl_spiral
