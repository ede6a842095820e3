// SPDX-License-Identifier: BSD-3-Clause
#include "quadric.h"

#include <cmath>

namespace pcl_spiral {
namespace {

/** The point of the quadric nearest to the origin, by Newton's method from above it. */
bool
nearestOnQuadric(const Vector6d& b, double& u, double& v)
{
  const double fuu = 2.0 * b[3], fuv = b[4], fvv = 2.0 * b[5];
  u = v = 0.0;
  for (int iteration = 0; iteration < 8; ++iteration) {
    const double f = b[0] + b[1] * u + b[2] * v + b[3] * u * u + b[4] * u * v + b[5] * v * v;
    const double fu = b[1] + fuu * u + fuv * v, fv = b[2] + fuv * u + fvv * v;
    const double gu = u + f * fu, gv = v + f * fv;
    const double huu = 1.0 + fu * fu + f * fuu, huv = fu * fv + f * fuv, hvv = 1.0 + fv * fv + f * fvv;
    const double determinant = huu * hvv - huv * huv;
    if (!(determinant > 0.0))
      return false;
    const double du = (hvv * gu - huv * gv) / determinant, dv = (huu * gv - huv * gu) / determinant;
    u -= du;
    v -= dv;
    if (du * du + dv * dv < 1e-20)
      break;
  }
  return u * u + v * v < 1.0;
}

/** Normal, principal curvatures and direction of the quadric at (u, v); lengths over \p radius. */
void
shapeOfQuadric(const Vector6d& b, double u, double v, double radius, const Eigen::Vector3d& e1, const Eigen::Vector3d& e2,
               const Eigen::Vector3d& up, SurfaceFoot& foot)
{
  const double fuu = 2.0 * b[3], fuv = b[4], fvv = 2.0 * b[5];
  const double fu = b[1] + fuu * u + fuv * v, fv = b[2] + fuv * u + fvv * v;
  const double area = std::sqrt(1.0 + fu * fu + fv * fv);
  foot.normal = (up - fu * e1 - fv * e2) / area;
  // An orthonormal tangent frame (t1, t2) in terms of the coordinate tangents x_u = e1 + fu up, x_v = e2 + fv up.
  const double e = 1.0 + fu * fu, f = fu * fv, root = std::sqrt(e);
  const Eigen::Vector3d t1 = (e1 + fu * up) / root, t2 = foot.normal.cross(t1);
  const double a = 1.0 / root, c = -f / (root * area), d = root / area; // t1 = a x_u, t2 = c x_u + d x_v
  const double l = -fuu / area, m = -fuv / area, n = -fvv / area;       // convex positive
  const double k11 = a * a * l, k12 = a * (c * l + d * m), k22 = c * c * l + 2.0 * c * d * m + d * d * n;
  const double mean = 0.5 * (k11 + k22), half = 0.5 * (k11 - k22), spread = std::sqrt(half * half + k12 * k12);
  foot.curvature1 = (mean + spread) / radius;
  foot.curvature2 = (mean - spread) / radius;
  // Of the two columns of shape - curvature2, the longer.
  const double p = half >= 0.0 ? spread + half : k12, q = half >= 0.0 ? k12 : spread - half;
  const double length = std::sqrt(p * p + q * q);
  foot.direction1 = length > 0.0 ? Eigen::Vector3d((p * t1 + q * t2) / length) : t1;
}

} // namespace

bool
standOnQuadric(const Vector6d& b, double radius, const Eigen::Vector3d& e1, const Eigen::Vector3d& e2, const Eigen::Vector3d& up,
               SurfaceFoot& foot)
{
  double u = 0.0, v = 0.0;
  if (!nearestOnQuadric(b, u, v))
    return false;
  const double f = b[0] + b[1] * u + b[2] * v + b[3] * u * u + b[4] * u * v + b[5] * v * v;
  foot.position += radius * (u * e1 + v * e2 + f * up);
  shapeOfQuadric(b, u, v, radius, e1, e2, up, foot);
  return true;
}

} // namespace pcl_spiral
