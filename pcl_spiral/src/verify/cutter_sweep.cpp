#include <pcl_spiral/verify/cutter_sweep.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

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

/** Where the line x + t n enters the capsule between the origin and \p d. The side of its cylinder, or where
 * that is met beyond an end, the ball there: a convex body is entered once. */
bool
entersCapsule(const Eigen::Vector3d& x, const Eigen::Vector3d& n, const Eigen::Vector3d& d, double radius, double& t)
{
  const double dd = d.squaredNorm(), nd = n.dot(d), md = x.dot(d);
  const double a = dd - nd * nd;
  if (a <= 1e-14 * dd) // along the line, or no move at all: the end met first
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

double
heightAbove(const SurfaceFoot& foot, const Eigen::Vector3d& p)
{
  const Eigen::Vector3d e2 = foot.normal.cross(foot.direction1), d = p - foot.position;
  const double a = d.dot(foot.direction1), b = d.dot(e2), z = d.dot(foot.normal);
  const double k1 = foot.curvature1, k2 = foot.curvature2;
  // The nearest point (u, v, w) of w = -(k1 u^2 + k2 v^2) / 2: u (1 + k1 (z - w)) = a, v likewise, by fixed point.
  double u = a, v = b, w = 0.0;
  for (int i = 0; i < 20; ++i) {
    const double before = w;
    const double gu = 1.0 + k1 * (z - w), gv = 1.0 + k2 * (z - w);
    u = gu > 0.1 ? a / gu : a;
    v = gv > 0.1 ? b / gv : b;
    w = -0.5 * (k1 * u * u + k2 * v * v);
    if (std::abs(w - before) < 1e-13)
      break;
  }
  const double distance = std::sqrt((a - u) * (a - u) + (b - v) * (b - v) + (z - w) * (z - w));
  return z >= w ? distance : -distance;
}

BallSweep::BallSweep(const Polyline& contacts, const std::vector<Eigen::Vector3d>& normals, double radius)
: CutterSweep(offset(contacts, normals, radius), radius)
{
}

bool
BallSweep::enter(std::size_t move, const Eigen::Vector3d& x, const Eigen::Vector3d& n, double start, double& t) const
{
  const Eigen::Vector3d& a = centres()[move];
  const Eigen::Vector3d& b = centres()[move + 1];
  double first = 0.0;
  if (!entersCapsule(x - a, n, b - a, boundingRadius(), first) || first >= t)
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
  return squaredDistanceToSegment(x, centres()[move], centres()[move + 1]) <= boundingRadius() * boundingRadius();
}

double
BallSweep::depth(std::size_t move, double f, const SurfaceFoot& foot) const
{
  return boundingRadius() - heightAbove(foot, (1.0 - f) * centres()[move] + f * centres()[move + 1]);
}

} // namespace pcl_spiral
