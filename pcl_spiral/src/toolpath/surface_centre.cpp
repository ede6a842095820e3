#include <pcl_spiral/toolpath/surface_centre.h>

#include <pcl_spiral/core/enclosing_circle.h>
#include <pcl_spiral/core/frame.h>
#include <pcl_spiral/geodesic/distance_field.h>

#include <Eigen/LU>

#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

constexpr std::size_t rim_samples = 96;
constexpr int most_rounds = 12;
constexpr double settled = 5e-4; // spacings

/** Centre of the rim's smallest enclosing circle in the plane across its mean normal, put on the surface. */
SurfaceFoot
firstGuess(const MlsSurface& surface, const Polyline& rim)
{
  const SurfaceGraph& graph = surface.graph();
  Eigen::Vector3d up = graph.meanNormal().normalized(), e1, e2, mean = Eigen::Vector3d::Zero();
  tangentFrame(up, e1, e2);
  std::vector<Eigen::Vector2d> plan;
  for (const Eigen::Vector3d& p : rim) {
    plan.emplace_back(p.dot(e1), p.dot(e2));
    mean += p / static_cast<double>(rim.size());
  }
  const Circle circle = smallestEnclosingCircle(plan);
  // The cloud's point nearest to the axis of that circle.
  double best = 1e300;
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < graph.size(); ++i) {
    const Eigen::Vector3d p = graph.position(i);
    const double distance = std::hypot(p.dot(e1) - circle.centre.x(), p.dot(e2) - circle.centre.y());
    if (distance < best) {
      best = distance;
      nearest = i;
    }
  }
  const Eigen::Vector3d on_axis = circle.centre.x() * e1 + circle.centre.y() * e2;
  const Eigen::Vector3d p = graph.position(nearest);
  return surface.project(best < graph.spacing() ? Eigen::Vector3d(on_axis + p.dot(up) * up) : p);
}

/** Where the rim's points lie in the tangent plane of \p foot, by distance and direction along the surface. */
std::vector<Eigen::Vector2d>
logMap(const DistanceField& field, const SurfaceFoot& foot, const Polyline& rim, double spacing)
{
  Eigen::Vector3d e1, e2;
  tangentFrame(foot.normal, e1, e2);
  std::vector<Eigen::Vector2d> plane(rim.size(), Eigen::Vector2d::Zero());
  const auto count = static_cast<std::int64_t>(rim.size());
#pragma omp parallel for schedule(dynamic, 4)
  for (std::int64_t i = 0; i < count; ++i) {
    const Polyline line = field.trace(rim[i]);
    const double whole = length(line);
    double gone = 0.0;
    for (std::size_t k = 1; k < line.size(); ++k) {
      gone += (line[k] - line[k - 1]).norm();
      if (gone < 6.0 * spacing && k + 1 < line.size())
        continue;
      const Eigen::Vector3d d = line[k] - foot.position;
      const Eigen::Vector2d direction(d.dot(e1), d.dot(e2));
      if (direction.norm() > 0.0)
        plane[i] = whole * direction.normalized();
      break;
    }
  }
  return plane;
}

/** Centre of the points by the least sum of distances to the 16th power, close to the smallest circle's; unlike that it
 *  moves smoothly when the points do. Newton's method from the smallest circle. */
Eigen::Vector2d
smoothCentre(const std::vector<Eigen::Vector2d>& points)
{
  constexpr double power = 16.0;
  const Circle circle = smallestEnclosingCircle(points);
  Eigen::Vector2d centre = circle.centre;
  for (int iteration = 0; iteration < 40 && circle.radius > 0.0; ++iteration) {
    Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
    Eigen::Matrix2d hessian = Eigen::Matrix2d::Zero();
    for (const Eigen::Vector2d& p : points) {
      const Eigen::Vector2d d = (p - centre) / circle.radius;
      const double distance = d.norm();
      if (!(distance > 0.0))
        continue;
      const double weight = std::pow(distance, power - 2.0);
      const Eigen::Vector2d u = d / distance;
      gradient += weight * d;
      hessian += weight * (Eigen::Matrix2d::Identity() + (power - 2.0) * u * u.transpose());
    }
    const Eigen::Vector2d step = hessian.inverse() * gradient * circle.radius;
    if (!step.allFinite())
      break;
    centre += step;
    if (step.norm() < 1e-12 * circle.radius)
      break;
  }
  return centre;
}

} // namespace

std::optional<Eigen::Vector3d>
chebyshevCentre(const MlsSurface& surface, const Polyline& rim)
{
  const Polyline sample = resampled(rim, rim_samples, true);
  const double spacing = surface.graph().spacing();
  SurfaceFoot foot = firstGuess(surface, sample);
  if (!foot.valid)
    return std::nullopt;
  double share = 1.0, last_step = std::numeric_limits<double>::max(); // of the way, less where rounds go to and fro
  for (int round = 0; round < most_rounds; ++round) {
    DistanceField field;
    if (!field.compute(surface.graph(), foot.position))
      return std::nullopt;
    const Eigen::Vector2d centre = smoothCentre(logMap(field, foot, sample, spacing));
    if (centre.norm() > 0.5 * last_step)
      share *= 0.5;
    last_step = centre.norm();
    Eigen::Vector3d e1, e2;
    tangentFrame(foot.normal, e1, e2);
    Eigen::Vector3d step = share * (centre.x() * e1 + centre.y() * e2);
    SurfaceFoot next;
    for (int halving = 0; halving < 6 && !next.valid; ++halving, step *= 0.5) {
      // Follow the surface in short tangent steps.
      next = foot;
      const int pieces = std::max(1, static_cast<int>(std::ceil(step.norm() / (2.0 * spacing))));
      Eigen::Vector3d direction = step / pieces;
      for (int i = 0; i < pieces && next.valid; ++i) {
        const Eigen::Vector3d along = direction - direction.dot(next.normal) * next.normal;
        if (along.norm() > 0.0)
          direction = along.normalized() * (step.norm() / pieces);
        next = surface.project(next.position + direction);
      }
    }
    if (!next.valid)
      break;
    const double moved = (next.position - foot.position).norm();
    foot = next;
    if (moved < settled * spacing)
      break;
  }
  return foot.position;
}

std::optional<Eigen::Vector3d>
deepestPoint(const MlsSurface& surface, const Polyline& rim)
{
  DistanceField field;
  if (!field.compute(surface.graph(), rim))
    return std::nullopt;
  std::size_t deepest = 0;
  double most = -1.0;
  for (std::size_t i = 0; i < surface.graph().size(); ++i)
    if (std::isfinite(field.distance(i)) && field.distance(i) > most) {
      most = field.distance(i);
      deepest = i;
    }
  const SurfaceFoot foot = surface.project(surface.graph().position(deepest));
  return foot.valid ? std::optional<Eigen::Vector3d>(foot.position) : std::nullopt;
}

} // namespace pcl_spiral
