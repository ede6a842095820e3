// SPDX-License-Identifier: BSD-3-Clause
#include "front_march.h"

#include "mesh_walk.h"

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr double bucket_width = 0.5; // in spacings
constexpr std::size_t bucket_count = 256;
constexpr double least_gain = 1e-6;    // in spacings
constexpr double straight_front = 1e4; // radius in spacings at which a front counts as straight

} // namespace

FrontMarch::FrontMarch(const SurfaceGraph& graph, std::vector<double>& distances, std::vector<Eigen::Vector3f>& gradients)
: graph_(graph), mesh_(graph.triangulation()), distances_(distances), gradients_(gradients), centres_(graph.size(), 0.0),
  state_(graph.size(), State::Far), least_gain_(least_gain * graph.spacing()), queue_(bucket_width * graph.spacing(), bucket_count)
{}

void
FrontMarch::addSeed(std::uint32_t point, double distance, const Eigen::Vector3d& gradient, double centre)
{
  distances_[point] = distance;
  gradients_[point] = gradient.cast<float>();
  centres_[point] = centre;
  state_[point] = State::Waiting;
  queue_.push(point, distance);
}

void
FrontMarch::run()
{
  while (queue_.pop(front_)) {
    settleFront();
    const auto takeShorter = [this](const Way& way) {
      if (way.distance < distances_[way.to] - least_gain_)
        take(way);
    };
    round_.run(
        front_, [this](std::uint32_t v, Ways& ways) { visit(v, ways); }, takeShorter);
  }
  straightenGradients();
}

void
FrontMarch::settleFront()
{
  std::size_t kept = 0;
  for (const std::uint32_t v : front_)
    if (state_[v] == State::Waiting) {
      state_[v] = State::Settled;
      front_[kept++] = v;
    }
  front_.resize(kept);
}

void
FrontMarch::visit(std::uint32_t v, Ways& ways) const
{
  for (std::uint32_t i = mesh_.outgoingBegin(v); i < mesh_.outgoingBegin(v + 1); ++i) {
    const std::uint32_t h = mesh_.outgoing(i), before = Triangulation::previous(h);
    const std::uint32_t a = mesh_.target(h), b = mesh_.origin(before);
    tryAlong(v, a, ways);
    if (mesh_.opposite(before) == Triangulation::none)
      tryAlong(v, b, ways);
    if (settled(a))
      tryAcross(a, v, b, ways);
    if (settled(b))
      tryAcross(b, v, a, ways);
  }
}

void
FrontMarch::take(const Way& way)
{
  distances_[way.to] = way.distance;
  gradients_[way.to] = way.step;
  centres_[way.to] = way.centre;
  state_[way.to] = State::Waiting;
  queue_.push(way.to, way.distance);
}

void
FrontMarch::straightenGradients()
{
  const auto count = static_cast<std::int64_t>(graph_.size());
#pragma omp parallel for schedule(static)
  for (std::int64_t i = 0; i < count; ++i) {
    const Eigen::Vector3d normal = graph_.normal(i), step = gradients_[i].cast<double>();
    gradients_[i] = (step - normal * normal.dot(step)).normalized().cast<float>();
  }
}

void
FrontMarch::tryAlong(std::uint32_t v, std::uint32_t j, Ways& ways) const
{
  if (distances_[j] <= distances_[v])
    return;
  const Eigen::Vector3d step = graph_.position(j) - graph_.position(v);
  const double distance = distances_[v] + step.norm();
  if (distance < distances_[j] - least_gain_)
    ways.push_back({distance, centres_[v], step.cast<float>(), j});
}

double
FrontMarch::commonCentre(std::uint32_t a, std::uint32_t v) const
{
  if (centres_[a] == centres_[v])
    return centres_[a];
  const double mean = 0.5 * (distances_[a] + distances_[v]);
  const double curvature = 0.5 * (1.0 / (distances_[a] - centres_[a]) + 1.0 / (distances_[v] - centres_[v]));
  const double most = straight_front * graph_.spacing();
  return std::abs(curvature) * most > 1.0 ? mean - 1.0 / curvature : mean - most;
}

void
FrontMarch::tryAcross(std::uint32_t a, std::uint32_t v, std::uint32_t j, Ways& ways) const
{
  const double da = distances_[a], dv = distances_[v], nearer = std::min(da, dv);
  if (distances_[j] <= nearer)
    return;
  const Eigen::Vector3d pa = graph_.position(a), to_j = graph_.position(j) - pa;
  Eigen::Vector3d edge = graph_.position(v) - pa;
  const double c = edge.norm();
  if (!(c > 0.0))
    return;
  edge /= c;
  // In the triangle's plane a is the origin, v lies on x at c, j at (jx, jy) above.
  const double jx = to_j.dot(edge), jy = std::sqrt(std::max(0.0, to_j.squaredNorm() - jx * jx));
  const double centre = commonCentre(a, v);
  const double ra = da - centre, rv = dv - centre;
  if (!(ra * rv > 0.0) || !(jy > 0.0))
    return;
  const double side = ra > 0.0 ? -1.0 : 1.0; // the centre lies behind the edge, or beyond it
  const double cx = ((ra - rv) * (ra + rv) + c * c) / (2.0 * c), squared = (ra - cx) * (ra + cx);
  if (!(squared > 0.0))
    return;
  const double cy = side * std::sqrt(squared);
  if (side > 0.0 && jy >= cy)
    return;
  const double crossing = cx + (jx - cx) * cy / (cy - jy);
  if (!(crossing > 0.0 && crossing < c))
    return;
  const double distance = centre - side * std::sqrt((jx - cx) * (jx - cx) + (jy - cy) * (jy - cy));
  if (distance > nearer && distance < distances_[j] - least_gain_)
    ways.push_back({distance, centre, (to_j - crossing * edge).cast<float>(), j});
}

} // namespace pcl_spiral
