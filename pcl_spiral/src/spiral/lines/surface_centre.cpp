// SPDX-License-Identifier: BSD-3-Clause
#include "surface_centre.h"

#include "geodesic/distance_field.h"
#include <pcl_spiral/core/impl/frame.h>
#include <pcl_spiral/geodesic/impl/geodesic_refinement.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

constexpr std::size_t rim_samples = 96;
constexpr int most_moves = 12;
constexpr double farthest_drift = 3.0; // spacings: largest distance of the centre from the source of the field that starts lines
constexpr double lasting_drift = 0.5;  // the same if some lines come from the field itself, because no geodesic leads there
constexpr double settled = 5e-3;       // spacings: a smaller move ends the search, for the next would be a hundred times smaller

/** Lines from a centre under way to the samples of the rim. */
struct Fan {
  std::vector<Polyline> lines;
  std::vector<std::uint8_t> geodesic; ///< 0: no geodesic leads there, as behind a re-entrant rim, and the line of the field is used

  bool isGeodesic() const { return std::count(geodesic.begin(), geodesic.end(), 0) == 0; }
};

/** Make geodesics from \p centre. They start from the fan's lines about a nearby centre, or from the lines of \p start if the fan
 *  has none. */
void
refineFan(const MlsSurface& surface, const StartLines& start, const Eigen::Vector3d& centre, const Polyline& rim, Fan& fan)
{
  fan.lines.resize(rim.size());
  fan.geodesic.resize(rim.size(), 0);
  std::vector<GeodesicLine> geodesics(rim.size());
  const auto count = static_cast<std::int64_t>(rim.size());
#pragma omp parallel for schedule(dynamic, 4)
  for (std::int64_t i = 0; i < count; ++i) {
    Polyline& line = fan.lines[i];
    if (fan.geodesic[i]) {
      const Eigen::Vector3d shift = centre - line.front();
      for (std::size_t k = 0; k < line.size(); ++k)
        line[k] += (1.0 - static_cast<double>(k) / static_cast<double>(line.size() - 1)) * shift;
    }
    else
      line = start.between(centre, rim[i]);
    geodesics[i].points = line;
  }
  RefinementOptions options;
  options.levels = {32};
  options.max_iterations = 8;
  options.probe_normals = false;
  options.tolerance = 1e-4 * surface.graph().spacing();
  refineGeodesics(surface, options, geodesics);
  for (std::size_t i = 0; i < rim.size(); ++i) {
    fan.geodesic[i] = geodesics[i].points.size() > 1 && !geodesics[i].left_surface;
    if (fan.geodesic[i])
      fan.lines[i] = std::move(geodesics[i].points);
  }
}

/** The ends of the fan's lines in the tangent plane of \p foot, by distance and direction. */
std::vector<Eigen::Vector2d>
logMap(const Fan& fan, const SurfaceFoot& foot, double spacing)
{
  Eigen::Vector3d e1, e2;
  tangentFrame(foot.normal, e1, e2);
  std::vector<Eigen::Vector2d> plane(fan.lines.size(), Eigen::Vector2d::Zero());
  for (std::size_t i = 0; i < fan.lines.size(); ++i) {
    const Polyline& line = fan.lines[i];
    double gone = 0.0;
    for (std::size_t k = 1; k < line.size(); ++k) {
      gone += (line[k] - line[k - 1]).norm();
      if (gone < 6.0 * spacing && k + 1 < line.size())
        continue;
      const Eigen::Vector3d d = line[k] - foot.position;
      const Eigen::Vector2d direction(d.dot(e1), d.dot(e2));
      if (direction.norm() > 0.0)
        plane[i] = length(line) * direction.normalized();
      break;
    }
  }
  return plane;
}

/** log ((sum d^p)^(1/p) (sum d^-p)^(b/p)) of the distances d from \p x to the points: a smooth form of the largest
 *  distance times the smallest to the power -b. With its gradient and second derivatives. */
double
unevenness(const std::vector<Eigen::Vector2d>& points, const Eigen::Vector2d& x, Eigen::Vector2d& gradient, Eigen::Matrix2d& hessian)
{
  constexpr double p = 16.0, b = 0.5;
  const Eigen::Matrix2d unit = Eigen::Matrix2d::Identity();
  double scale = 0.0;
  for (const Eigen::Vector2d& q : points)
    scale = std::max(scale, (q - x).norm());
  double far = 0.0, near = 0.0;
  Eigen::Vector2d far_slope = Eigen::Vector2d::Zero(), near_slope = far_slope;
  Eigen::Matrix2d far_bend = Eigen::Matrix2d::Zero(), near_bend = far_bend;
  for (const Eigen::Vector2d& q : points) {
    const double d = std::max((x - q).norm() / scale, 1e-6);
    const Eigen::Vector2d u = (x - q) / (scale * d);
    far += std::pow(d, p);
    far_slope += std::pow(d, p - 1.0) * u;
    far_bend += std::pow(d, p - 2.0) * (unit + (p - 2.0) * u * u.transpose());
    near += std::pow(d, -p);
    near_slope -= std::pow(d, -p - 1.0) * u;
    near_bend -= std::pow(d, -p - 2.0) * (unit - (p + 2.0) * u * u.transpose());
  }
  far_slope /= far;
  near_slope /= near;
  gradient = (far_slope + b * near_slope) / scale;
  hessian = (far_bend / far - p * far_slope * far_slope.transpose() + b * (near_bend / near - p * near_slope * near_slope.transpose())) /
            (scale * scale);
  return std::log(scale) * (1.0 - b) + (std::log(far) + b * std::log(near)) / p;
}

/** The place of least unevenness near the origin: Newton's method, downhill where the function is not convex. */
Eigen::Vector2d
evenCentre(const std::vector<Eigen::Vector2d>& points)
{
  Eigen::Vector2d x = Eigen::Vector2d::Zero(), gradient, unused_gradient;
  Eigen::Matrix2d hessian, unused_hessian;
  for (int iteration = 0; iteration < 60; ++iteration) {
    const double value = unevenness(points, x, gradient, hessian);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(hessian);
    const Eigen::Vector2d bend = eigen.eigenvalues().cwiseAbs().cwiseMax(1e-6 * eigen.eigenvalues().cwiseAbs().maxCoeff());
    Eigen::Vector2d step = -(eigen.eigenvectors() * (eigen.eigenvectors().transpose() * gradient).cwiseQuotient(bend));
    if (!step.allFinite())
      break;
    int halving = 0;
    while (halving < 40 && unevenness(points, x + step, unused_gradient, unused_hessian) > value) {
      step *= 0.5;
      ++halving;
    }
    if (halving == 40)
      break;
    x += step;
    if (step.norm() < 1e-12 * points[0].norm())
      break;
  }
  return x;
}

/** Whether \p x lies within the closed line: an odd number of its edges lies to the right. */
bool
isInside(const std::vector<Eigen::Vector2d>& line, const Eigen::Vector2d& x)
{
  bool inside = false;
  for (std::size_t i = 0, j = line.size() - 1; i < line.size(); j = i++)
    if ((line[i].y() > x.y()) != (line[j].y() > x.y()) &&
        x.x() < line[i].x() + (x.y() - line[i].y()) / (line[j].y() - line[i].y()) * (line[j].x() - line[i].x()))
      inside = !inside;
  return inside;
}

/** The even centre of the rim as seen along the mean normal, projected onto the surface: a start close to the result. */
SurfaceFoot
startInPlan(const MlsSurface& surface, const Polyline& rim)
{
  constexpr int cells = 24; // of the box about the rim, each way
  const SurfaceGraph& graph = surface.graph();
  const Eigen::Vector3d up = graph.meanNormal().normalized();
  Eigen::Vector3d e1, e2;
  tangentFrame(up, e1, e2);
  std::vector<Eigen::Vector2d> plan;
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector3d& p : rim) {
    plan.emplace_back(p.dot(e1), p.dot(e2));
    box.extend(plan.back());
  }
  std::optional<Eigen::Vector2d> best;
  double least = std::numeric_limits<double>::infinity();
  Eigen::Vector2d gradient;
  Eigen::Matrix2d hessian;
  for (int i = 0; i < cells * cells; ++i) {
    const int column = i % cells, row = i / cells;
    const Eigen::Vector2d x = box.min() + Eigen::Vector2d(column + 0.5, row + 0.5).cwiseProduct(box.sizes()) / cells;
    if (!isInside(plan, x))
      continue;
    if (const double value = unevenness(plan, x, gradient, hessian); value < least) {
      least = value;
      best = x;
    }
  }
  SurfaceFoot none;
  if (!best)
    return none;
  std::vector<Eigen::Vector2d> about = plan;
  for (Eigen::Vector2d& p : about)
    p -= *best;
  *best += evenCentre(about);
  double closest = std::numeric_limits<double>::infinity();
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < graph.size(); ++i) {
    const Eigen::Vector3d p = graph.position(i);
    const double squared = (Eigen::Vector2d(p.dot(e1), p.dot(e2)) - *best).squaredNorm();
    if (squared < closest) {
      closest = squared;
      nearest = i;
    }
  }
  if (std::sqrt(closest) > graph.spacing(nearest))
    return none;
  return surface.project(best->x() * e1 + best->y() * e2 + graph.position(nearest).dot(up) * up);
}

/** \p step from \p foot over the surface, in short tangent steps; invalid if they leave it. */
SurfaceFoot
walked(const MlsSurface& surface, const SurfaceFoot& foot, const Eigen::Vector3d& step)
{
  SurfaceFoot next = foot;
  const int pieces = std::max(1, static_cast<int>(std::ceil(step.norm() / (2.0 * surface.graph().spacing()))));
  Eigen::Vector3d direction = step / pieces;
  for (int i = 0; i < pieces && next.valid; ++i) {
    const Eigen::Vector3d along = direction - direction.dot(next.normal) * next.normal;
    if (along.norm() > 0.0)
      direction = along.normalized() * (step.norm() / pieces);
    next = surface.project(next.position + direction);
  }
  return next;
}

/** Lines for the next round of a centre that has moved \p drift from the source of the field of \p start. If no geodesic leads to
 *  a part of the rim, lines of the field are used: then every point carries the field, and its source stays close to the centre. */
bool
followCentre(const MlsSurface& surface, const Eigen::Vector3d& centre, const Polyline& rim, StartLines& start, Fan& fan, double& drift)
{
  const auto follow = [&](double farthest) {
    if (drift > farthest * start.spacing()) {
      if (!start.setCentre(centre))
        return false;
      drift = 0.0;
    }
    refineFan(surface, start, centre, rim, fan);
    return true;
  };
  const bool whole = !fan.lines.empty() && fan.isGeodesic();
  if (!whole && !follow(fan.lines.empty() ? farthest_drift : lasting_drift))
    return false;
  if (whole)
    refineFan(surface, start, centre, rim, fan);
  if (fan.isGeodesic() || start.usesEveryPoint())
    return true;
  start.useEveryPoint();
  drift = std::numeric_limits<double>::max();
  return follow(lasting_drift);
}

} // namespace

std::optional<SurfaceCentre>
balancedCentre(const MlsSurface& surface, const Polyline& rim)
{
  const Polyline sample = resampled(rim, rim_samples, true);
  const double spacing = surface.graph().spacing();
  SurfaceFoot foot = startInPlan(surface, sample);
  if (!foot.valid) {
    const auto deepest = deepestPoint(surface, rim);
    if (!deepest)
      return std::nullopt;
    foot = surface.project(*deepest);
  }
  StartLines start(surface.graph());
  Fan fan;
  double share = 1.0, last_step = std::numeric_limits<double>::max(); // of the step, less if rounds go back and forth
  double drift = std::numeric_limits<double>::max();                  // of the centre since the field was computed
  bool at_rest = false;
  for (int round = 0; round < most_moves; ++round) {
    if (!followCentre(surface, foot.position, sample, start, fan, drift))
      return std::nullopt;
    const Eigen::Vector2d goal = evenCentre(logMap(fan, foot, spacing));
    if (goal.norm() > 0.5 * last_step)
      share *= 0.5;
    last_step = goal.norm();
    Eigen::Vector3d e1, e2;
    tangentFrame(foot.normal, e1, e2);
    Eigen::Vector3d step = share * (goal.x() * e1 + goal.y() * e2);
    SurfaceFoot next;
    for (int halving = 0; halving < 6 && !next.valid; ++halving, step *= 0.5)
      next = walked(surface, foot, step);
    if (!next.valid)
      break;
    const double moved = (next.position - foot.position).norm();
    foot = next;
    drift += moved;
    at_rest = moved < settled * spacing;
    if (at_rest)
      break;
  }
  if (drift > farthest_drift * start.spacing() && !start.setCentre(foot.position))
    return std::nullopt;
  return SurfaceCentre{foot.position, std::move(start), at_rest};
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
