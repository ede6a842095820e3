// SPDX-License-Identifier: BSD-3-Clause
#include "distance_field.h"

#include "front_march.h"
#include "mesh_walk.h"

#include <cmath>
#include <deque>

namespace pcl_spiral {
namespace {

constexpr double seed_radius = 4.0; // in spacings: near a point source, distances are taken straight
constexpr double seed_band = 3.0;   // the same near a curve
constexpr double flattest = 1e4;    // in spacings: radius of a front that counts as straight

/** Length of the arc over the offset \p d from the source to a point with the normal \p n; the curvature follows from
 *  the angle between the two. */
double
arcOver(const Eigen::Vector3d& d, const Eigen::Vector3d& n)
{
  const double r = d.norm();
  const double half_angle = r > 0.0 ? n.dot(d) / r : 0.0;
  return r * (1.0 + half_angle * half_angle / 6.0);
}

Eigen::Vector3d
tangentPart(const Eigen::Vector3d& d, const Eigen::Vector3d& n)
{
  const Eigen::Vector3d t = d - n * n.dot(d);
  const double length = t.norm();
  return length > 1e-9 ? Eigen::Vector3d(t / length) : Eigen::Vector3d::Zero();
}

/** A closed curve in short equal segments, with its curvature. */
class SourceCurve {
public:
  struct Foot {
    Eigen::Vector3d position;
    std::size_t sample;
    double distance;
  };

  SourceCurve(const Polyline& curve, double step)
  {
    const double whole = length(curve, true);
    samples_ = resampled(curve, std::max<std::size_t>(12, static_cast<std::size_t>(whole / step)), true);
  }
  const Polyline& samples() const { return samples_; }

  /** Nearest point of the curve, walking from sample \p k. */
  Foot foot(const Eigen::Vector3d& x, std::size_t k) const
  {
    const std::size_t n = samples_.size();
    double here = (samples_[k] - x).squaredNorm();
    for (const std::size_t way : {std::size_t(1), n - 1})
      for (std::size_t next = (k + way) % n;; next = (k + way) % n) {
        const double there = (samples_[next] - x).squaredNorm();
        if (!(there < here))
          break;
        here = there;
        k = next;
      }
    Foot best{samples_[k], k, std::sqrt(here)};
    for (const std::size_t other : {(k + 1) % n, (k + n - 1) % n}) {
      const Eigen::Vector3d along = samples_[other] - samples_[k];
      const double f = std::min(1.0, std::max(0.0, (x - samples_[k]).dot(along) / along.squaredNorm()));
      const Eigen::Vector3d p = samples_[k] + f * along;
      if ((x - p).norm() < best.distance)
        best = {p, k, (x - p).norm()};
    }
    return best;
  }

  /** Curvature vector over two spacings in both directions. */
  Eigen::Vector3d curvature(std::size_t k) const
  {
    const std::size_t n = samples_.size(), w = std::min<std::size_t>(4, n / 6);
    const Eigen::Vector3d after = samples_[(k + w) % n] - samples_[k], before = samples_[k] - samples_[(k + n - w) % n];
    return (after.normalized() - before.normalized()) / (0.5 * (after.norm() + before.norm()));
  }

private:
  Polyline samples_;
};

} // namespace

void
DistanceField::prepare(const SurfaceGraph& graph)
{
  graph_ = &graph;
  source_.clear();
  distances_.assign(graph.size(), unreached);
  gradients_.assign(graph.size(), Eigen::Vector3f::Zero());
}

bool
DistanceField::compute(const SurfaceGraph& graph, const Eigen::Vector3d& source)
{
  prepare(graph);
  const Triangulation& mesh = graph.triangulation();
  const std::uint32_t nearest = nearestPoint(graph, source, reachOf(graph), [&](std::uint32_t i) { return hasTriangles(mesh, i); });
  if (nearest == Triangulation::none)
    return false;
  source_.assign(1, source);
  FrontMarch march(graph, distances_, gradients_);
  std::vector<std::uint32_t> disc{nearest};
  for (std::size_t k = 0; k < disc.size(); ++k) {
    const std::uint32_t v = disc[k];
    const Eigen::Vector3d offset = graph.position(v) - source, normal = graph.normal(v);
    if (distances_[v] < unreached || (k > 0 && offset.norm() > seed_radius * graph.spacing()))
      continue;
    march.addSeed(v, arcOver(offset, normal), tangentPart(offset, normal), 0.0);
    forNeighbours(mesh, v, [&](std::uint32_t j) {
      if (!(distances_[j] < unreached))
        disc.push_back(j);
    });
  }
  march.run();
  return true;
}

bool
DistanceField::compute(const SurfaceGraph& graph, const Polyline& closed_source_curve)
{
  prepare(graph);
  const double whole = length(closed_source_curve, true);
  if (closed_source_curve.size() < 3 || !(whole > 0.0) || !std::isfinite(whole))
    return false;
  const Triangulation& mesh = graph.triangulation();
  const SourceCurve curve(closed_source_curve, 0.5 * graph.spacing());
  struct Candidate {
    std::uint32_t point;
    std::size_t sample;
  };
  std::deque<Candidate> queue;
  for (std::size_t k = 0; k < curve.samples().size(); ++k) {
    const std::uint32_t v = nearestPoint(graph, curve.samples()[k], reachOf(graph), [&](std::uint32_t i) { return hasTriangles(mesh, i); });
    if (v == Triangulation::none)
      return false;
    queue.push_back({v, k});
  }
  source_ = closed_source_curve;
  std::vector<SourceCurve::Foot> feet(graph.size(), {Eigen::Vector3d::Zero(), 0, unreached});
  std::vector<std::uint32_t> band;
  for (; !queue.empty(); queue.pop_front()) {
    const auto [v, k] = queue.front();
    const SourceCurve::Foot foot = curve.foot(graph.position(v), k);
    if (foot.distance > seed_band * graph.spacing() || !(foot.distance < feet[v].distance - 1e-9))
      continue;
    if (feet[v].distance == unreached)
      band.push_back(v);
    feet[v] = foot;
    forNeighbours(mesh, v, [&, sample = foot.sample](std::uint32_t j) { queue.push_back({j, sample}); });
  }
  FrontMarch march(graph, distances_, gradients_);
  const double most = flattest * graph.spacing();
  for (const std::uint32_t v : band) {
    const SourceCurve::Foot& foot = feet[v];
    const Eigen::Vector3d offset = graph.position(v) - foot.position, normal = graph.normal(v);
    const Eigen::Vector3d away = tangentPart(offset, normal);
    const double towards = curve.curvature(foot.sample).dot(away);
    double centre = std::abs(towards) * most > 1.0 ? 1.0 / towards : -most;
    const double distance = arcOver(offset, normal);
    if (centre > 0.0 && centre < 2.0 * distance)
      centre = -most;
    march.addSeed(v, distance, away, centre);
  }
  march.run();
  return true;
}

double
DistanceField::distanceAt(const Eigen::Vector3d& position) const
{
  const std::uint32_t v = graph_ ? nearestReached(position) : Triangulation::none;
  if (v == Triangulation::none)
    return unreached;
  const double reach = 2.0 * graph_->spacing(v);
  double sum = 0.0, weights = 0.0;
  const auto add = [&](std::uint32_t j, double least) {
    const Eigen::Vector3d d = position - graph_->position(j);
    const double inside = std::max(least, 1.0 - d.squaredNorm() / (reach * reach));
    if (!(distances_[j] < unreached))
      return;
    sum += inside * inside * (distances_[j] + gradient(j).dot(d));
    weights += inside * inside;
  };
  add(v, 0.01);
  forNeighbours(graph_->triangulation(), v, [&](std::uint32_t j) { add(j, 0.0); });
  return std::max(0.0, sum / weights);
}

} // namespace pcl_spiral
