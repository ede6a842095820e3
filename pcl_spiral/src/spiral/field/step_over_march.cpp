// SPDX-License-Identifier: BSD-3-Clause
#include "step_over_march.h"

#include "core/median.h"
#include "geodesic/bucket_queue.h"
#include "geodesic/front_round.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double worth_a_step = 1e-7;         // a smaller gain does not count as a shorter way
constexpr std::size_t visits_a_report = 4096; // from one report of the progress to the next
constexpr std::size_t edges_looked_at = 4096; // for their median
constexpr std::size_t bucket_count = 4096;
constexpr double bucket_edges = 0.25; // width of a bucket; visits a node on the free form: 1.08, 1.12, 1.21, 1.40 with 0.1, 0.25, 0.5, 1

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

/** The least gain that counts at a node, by its visits so far. It doubles with each: in thin triangles, nodes correct each other by ever
 *  less, thousands of times. So a node has at most 24 visits for gains up to a step-over, and one more for each doubling of these. */
const std::array<double, 256> worth_again = [] {
  std::array<double, 256> worth{};
  for (int visits = 0; visits < 256; ++visits)
    worth[visits] = std::ldexp(worth_a_step, visits);
  return worth;
}();

constexpr double not_reached = std::numeric_limits<double>::infinity();
constexpr MarchedDistances::Side nowhere{Triangulation::none, Triangulation::none};

/** Carries known distances to the nodes with infinite ones. */
class StepOverMarch {
public:
  StepOverMarch(const StepOverMesh& mesh, MarchedDistances& marched)
  : mesh_(mesh.triangles), distance_(marched.distance), over_(marched.over), sides_(allSides(mesh)), is_open_(openTriangles()),
    visits_(mesh.size(), 0), waiting_(mesh.size(), 0), queue_(bucket_edges * usualEdge(), bucket_count)
  {
    std::vector<std::uint8_t> begins(mesh.size());
    double least = not_reached;
    std::size_t unknown = 0;
    const auto count = static_cast<std::int64_t>(mesh.size());
#pragma omp parallel for schedule(static, 4096) reduction(min : least) reduction(+ : unknown)
    for (std::int64_t v = 0; v < count; ++v) {
      least = std::min(least, distance_[v]);
      unknown += !std::isfinite(distance_[v]);
      begins[v] = std::isfinite(distance_[v]) && isBesideUnknown(static_cast<std::uint32_t>(v));
    }
    least_ = least;
    unknown_ = unknown;
    for (std::uint32_t v = 0; v < mesh.size(); ++v)
      if (begins[v])
        wait(v);
  }

  bool run(const std::function<bool(double)>& progress)
  {
    std::size_t visits = 0, reports = 0;
    while (queue_.pop(front_)) {
      settle();
      visits += front_.size();
      if (visits / visits_a_report != reports) {
        reports = visits / visits_a_report;
        if (progress && !progress(std::min(1.0, static_cast<double>(visits) / static_cast<double>(unknown_ + 1))))
          return false;
      }
      round_.run(
          front_, [this](std::uint32_t v, std::vector<Way>& ways) { visit(v, ways); }, [this](const Way& way) { take(way); });
    }
    return true;
  }

private:
  struct Way {
    double distance;
    MarchedDistances::Side over;
    std::uint32_t to;
  };

  std::vector<std::uint8_t> openTriangles() const
  {
    std::vector<std::uint8_t> is_open(mesh_.triangleCount());
    const auto count = static_cast<std::int64_t>(is_open.size());
#pragma omp parallel for schedule(static, 4096)
    for (std::int64_t t = 0; t < count; ++t)
      for (const std::uint32_t v : mesh_.triangle(t))
        is_open[t] |= !std::isfinite(distance_[v]);
    return is_open;
  }
  bool isBesideUnknown(std::uint32_t v) const
  {
    for (std::size_t o = mesh_.outgoingBegin(v); o < mesh_.outgoingBegin(v + 1); ++o)
      if (is_open_[mesh_.outgoing(o) / 3])
        return true;
    return false;
  }
  /** The median side of triangles with a node to reach. */
  double usualEdge() const
  {
    const auto count = static_cast<std::size_t>(std::count(is_open_.begin(), is_open_.end(), 1));
    const std::size_t stride = count / edges_looked_at + 1;
    std::vector<float> edges;
    std::size_t at = 0;
    for (std::size_t t = 0; t < sides_.size(); ++t)
      if (is_open_[t] && at++ % stride == 0)
        edges.push_back(sides_[t][0]);
    return edges.empty() ? 1.0 : medianOf(std::move(edges));
  }
  void take(const Way& way)
  {
    if (!(way.distance < distance_[way.to] - worth_again[visits_[way.to]]))
      return;
    distance_[way.to] = way.distance;
    over_[way.to] = way.over;
    wait(way.to);
  }
  void wait(std::uint32_t v)
  {
    waiting_[v] = 1;
    queue_.push(v, distance_[v] - least_);
  }
  /** Settle the nodes of the round that still wait; forget the rest. */
  void settle()
  {
    std::size_t kept = 0;
    for (const std::uint32_t v : front_)
      if (waiting_[v]) {
        waiting_[v] = 0;
        ++visits_[v];
        front_[kept++] = v;
      }
    front_.resize(kept);
  }
  void visit(std::uint32_t i, std::vector<Way>& ways) const
  {
    const double d = distance_[i];
    for (std::size_t o = mesh_.outgoingBegin(i); o < mesh_.outgoingBegin(i + 1); ++o) {
      const std::uint32_t h = mesh_.outgoing(o);
      const std::size_t t = h / 3, ci = h % 3;
      for (std::size_t step = 1; step < 3; ++step) {
        const std::size_t cj = (ci + step) % 3, cq = 3 - ci - cj;
        const std::uint32_t j = mesh_.triangle(t)[cj], q = mesh_.triangle(t)[cq];
        const double ij = sides_[t][cq], qj = sides_[t][ci], iq = sides_[t][cj];
        const double dq = distance_[q], enough = distance_[j] - worth_again[visits_[j]];
        if (!(std::min(d, dq) < enough))
          continue;
        const double reached = std::isfinite(dq) ? acrossTriangle(d, dq, ij, qj, iq) : d + ij;
        if (reached < enough)
          ways.push_back({reached, {i, reached < d + ij ? q : i}, j});
      }
    }
  }

  const Triangulation& mesh_;
  std::vector<double>& distance_;
  std::vector<MarchedDistances::Side>& over_;
  std::vector<Sides> sides_;
  std::vector<std::uint8_t> is_open_; ///< one a triangle: whether it has a node to reach, at first
  std::vector<std::uint8_t> visits_, waiting_;
  double least_ = 0.0;
  std::size_t unknown_ = 0;
  BucketQueue queue_;
  std::vector<std::uint32_t> front_; ///< what settles in this round
  FrontRound<Way> round_;
};

} // namespace

void
MarchedDistances::resize(std::size_t nodes)
{
  distance.resize(nodes, not_reached);
  over.resize(nodes, nowhere);
}

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
distancesFromRims(const StepOverMesh& mesh, const std::vector<double>& starts)
{
  MarchedDistances marched;
  marched.resize(mesh.size());
  for (std::size_t r = 0; r < mesh.rims.size(); ++r)
    for (const std::uint32_t v : mesh.rims[r])
      marched.distance[v] = starts[r];
  StepOverMarch(mesh, marched).run({});
  return std::move(marched.distance);
}

bool
marchOn(const StepOverMesh& mesh, MarchedDistances& marched, const std::function<bool(double)>& progress)
{
  marched.resize(mesh.size());
  for (const std::vector<std::uint32_t>& rim : mesh.rims)
    for (const std::uint32_t v : rim)
      marched.distance[v] = 0.0;
  return StepOverMarch(mesh, marched).run(progress);
}

void
forgetBehind(const StepOverMesh& mesh, const std::vector<std::uint8_t>& chosen, MarchedDistances& marched)
{
  std::vector<std::uint32_t> todo;
  const auto forget = [&](std::uint32_t v) {
    if (marched.over[v] == nowhere)
      return;
    marched.distance[v] = not_reached;
    marched.over[v] = nowhere;
    todo.push_back(v);
  };
  for (std::size_t t = 0; t < chosen.size(); ++t)
    if (chosen[t])
      for (const std::uint32_t v : mesh.triangles.triangle(t))
        forget(v);
  while (!todo.empty()) {
    const std::uint32_t v = todo.back();
    todo.pop_back();
    for (std::size_t o = mesh.triangles.outgoingBegin(v); o < mesh.triangles.outgoingBegin(v + 1); ++o)
      for (const std::uint32_t w : mesh.triangles.triangle(mesh.triangles.outgoing(o) / 3))
        if (marched.over[w][0] == v || marched.over[w][1] == v)
          forget(w);
  }
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
    lengths[i] = static_cast<float>(std::sqrt(along * along + across * across));
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
