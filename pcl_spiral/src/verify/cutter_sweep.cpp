// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/verify/impl/cutter_sweep.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

constexpr double least = 1e-6, farthest = 1e9; // mm

Polyline
offset(const Polyline& contacts, const std::vector<Eigen::Vector3d>& normals, double distance)
{
  Polyline result(contacts.size());
  for (std::size_t i = 0; i < contacts.size(); ++i)
    result[i] = contacts[i] + distance * normals[i];
  return result;
}

double
squaredDistanceToSegment(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  const Eigen::Vector3d d = b - a;
  const double whole = d.squaredNorm();
  const double f = whole > 0.0 ? std::clamp((p - a).dot(d) / whole, 0.0, 1.0) : 0.0;
  return (p - a - f * d).squaredNorm();
}

/** Where the line x + t n enters the ball about the origin; false when it misses. */
bool
entersBall(const Eigen::Vector3d& x, const Eigen::Vector3d& n, double radius, double& t)
{
  const double middle = -x.dot(n), inside = radius * radius - (x + middle * n).squaredNorm();
  if (inside < 0.0)
    return false;
  t = middle - std::sqrt(inside);
  return true;
}

/** Where the line x + t n enters the capsule between the origin and \p d: at the side of its cylinder, or, if that is
 *  met beyond an end, at the ball there. A convex body is entered once. */
bool
entersCapsule(const Eigen::Vector3d& x, const Eigen::Vector3d& n, const Eigen::Vector3d& d, double radius, double& t)
{
  const double dd = d.squaredNorm(), nd = n.dot(d), md = x.dot(d);
  const double a = dd - nd * nd;
  if (a <= 1e-14 * dd) // along the line, or a move of no length: the end met first
    return entersBall(nd > 0.0 ? x : Eigen::Vector3d(x - d), n, radius, t);
  const double half = dd * x.dot(n) - nd * md;
  const double c = dd * (x.squaredNorm() - radius * radius) - md * md;
  const double inside = half * half - a * c;
  if (inside < 0.0)
    return false;
  t = (-half - std::sqrt(inside)) / a;
  const double along = md + t * nd;
  if (along >= 0.0 && along <= dd)
    return true;
  return entersBall(along < 0.0 ? x : Eigen::Vector3d(x - d), n, radius, t);
}

} // namespace

SurfaceHeight
heightAbove(const SurfaceFoot& foot, const Eigen::Vector3d& p, double reach)
{
  const Eigen::Vector3d e2 = foot.normal.cross(foot.direction1), d = p - foot.position;
  const double a = d.dot(foot.direction1), b = d.dot(e2), z = d.dot(foot.normal);
  const double k1 = foot.curvature1, k2 = foot.curvature2;
  // Of the surface w = -(k1 u^2 + k2 v^2) / 2 the point is l (k1 u, k2 v, 1) off: u = a / (1 + k1 l), v = b / (1 + k2 l),
  // and excess(l) = z - w - l vanishes. Where both 1 + k l are above 0, as at the nearest point, it falls all the way.
  const auto along = [&](double k, double offset, double l) { return std::max(std::abs(offset), least) / (1.0 + k * l); };
  const double lowest = k1 > 0.0 ? -1.0 / k1 : -farthest, highest = k2 < 0.0 ? -1.0 / k2 : farthest;
  double low = lowest, high = highest, l = std::clamp(z, 0.5 * lowest, 0.5 * highest), u = 0.0, v = 0.0;
  for (int i = 0; i < 200; ++i) {
    u = along(k1, a, l);
    v = along(k2, b, l);
    const double excess = z + 0.5 * (k1 * u * u + k2 * v * v) - l;
    (excess > 0.0 ? low : high) = l;
    const double slope = 1.0 + k1 * k1 * u * u / (1.0 + k1 * l) + k2 * k2 * v * v / (1.0 + k2 * l);
    const double next = l + excess / slope, before = l;
    l = next > low && next < high ? next : 0.5 * (low + high);
    if (std::abs(l - before) < 1e-13 * (1.0 + std::abs(l)))
      break;
  }
  const double inside = std::min(1.0, reach / std::hypot(u, v));
  u *= a < 0.0 ? -inside : inside;
  v *= b < 0.0 ? -inside : inside;
  const Eigen::Vector3d place = u * foot.direction1 + v * e2 - 0.5 * (k1 * u * u + k2 * v * v) * foot.normal;
  // Farther away than the reach, the tangent plane at the place decides the side.
  const Eigen::Vector3d across = k1 * u * foot.direction1 + k2 * v * e2 + foot.normal;
  const double distance =
      inside < 1.0 ? std::copysign((d - place).norm(), (d - place).dot(across)) : l * std::sqrt(1.0 + k1 * k1 * u * u + k2 * k2 * v * v);
  return {distance, foot.position + place};
}

BallSweep::BallSweep(const Polyline& contacts, const std::vector<Eigen::Vector3d>& normals, double radius,
                     const std::vector<std::size_t>& passes)
: CutterSweep(offset(contacts, normals, radius), radius, passes), index_(centres())
{}

bool
BallSweep::enter(std::size_t move, const Eigen::Vector3d& x, const Eigen::Vector3d& n, double start, double& t) const
{
  const Eigen::Vector3d& a = centres()[move];
  const Eigen::Vector3d& b = centres()[move + 1];
  double first = 0.0;
  if (isLift(move) || !entersCapsule(x - a, n, b - a, boundingRadius(), first) || first >= t)
    return false;
  if (first < -start) {
    if (-start >= t || !contains(move, x - start * n))
      return false;
    first = -start;
  }
  t = first;
  return true;
}

bool
BallSweep::contains(std::size_t move, const Eigen::Vector3d& x) const
{
  return !isLift(move) && squaredDistanceToSegment(x, centres()[move], centres()[move + 1]) <= boundingRadius() * boundingRadius();
}

double
BallSweep::depth(std::size_t move, const Eigen::Vector3d& x) const
{
  if (isLift(move))
    return -std::numeric_limits<double>::infinity();
  return boundingRadius() - std::sqrt(squaredDistanceToSegment(x, centres()[move], centres()[move + 1]));
}

void
BallSweep::enterAny(const Eigen::Vector3d& x, const Eigen::Vector3d& n, double start, Stock& stock) const
{
  // A ball with its middle farther away than this does not touch the rest of the ray.
  index_.search(
      x, [&] { return boundingRadius() + std::max(stock.height, start); }, [&](std::size_t move) { take(move, x, n, start, stock); });
}

double
BallSweep::deepest(const Eigen::Vector3d& x) const
{
  double most = 0.0;
  index_.search(
      x, [&] { return boundingRadius() - most; }, [&](std::size_t move) { most = std::max(most, depth(move, x)); });
  return most;
}

SurfaceHeight
BallSweep::lowest(std::size_t move, double f, const SurfaceFoot& foot, double reach) const
{
  const SurfaceHeight centre = heightAbove(foot, (1.0 - f) * centres()[move] + f * centres()[move + 1], reach);
  return {centre.height - boundingRadius(), centre.place};
}

} // namespace pcl_spiral
