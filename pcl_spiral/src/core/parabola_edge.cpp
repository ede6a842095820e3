// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/core/impl/parabola_edge.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {

using Eigen::Vector3d;

std::optional<double>
meanSlope(const Vector3d& d, const Vector3d& n0, const Vector3d& n1, const Vector3d& mean)
{
  constexpr double least = 0.1; // cosine
  const double c0 = n0.dot(mean), c1 = n1.dot(mean);
  if (!(c0 > least) || !(c1 > least))
    return std::nullopt;
  return 0.5 * (n0.dot(d) / c0 - n1.dot(d) / c1);
}

Vector3d
robustBow(const Vector3d& d, const Vector3d& n0, const Vector3d& n1)
{
  if (!(n0.dot(n1) > 0.0))
    return Vector3d::Zero();
  const Vector3d mean = (n0 + n1).normalized();
  return meanSlope(d, n0, n1, mean).value_or(0.0) * mean;
}

Vector3d
publishedBow(const Vector3d& d, const Vector3d& n0, const Vector3d& n1)
{
  constexpr double same = 1e-12;                                   // squared sine between the projections
  const Vector3d t0 = d - n0.dot(d) * n0, t1 = d - n1.dot(d) * n1; // forward from P0, and back from P1
  const double a = t0.squaredNorm(), b = t0.dot(t1), c = t1.squaredNorm();
  const double det = a * c - b * b;
  if (!(det > same * a * c))
    return Vector3d::Zero();
  // Nearest points P0 + s t0 and P1 - r t1.
  const double e = t0.dot(d), f = t1.dot(d);
  const double s = (c * e - b * f) / det, r = (a * f - b * e) / det;
  const Vector3d control = 0.5 * (s * t0 + d - r * t1); // relative to P0
  return d - 2.0 * control;
}

Vector3d
creaseBow(const Vector3d& d, const Vector3d& n0, const Vector3d& n1, const Vector3d& m0, const Vector3d& m1)
{
  constexpr double least_sine = 0.087; // 5 degrees
  if (!(n0.dot(n1) > 0.0) || !(m0.dot(m1) > 0.0))
    return Vector3d::Zero();
  const Vector3d n = (n0 + n1).normalized(), m = (m0 + m1).normalized();
  const std::optional<double> along_n = meanSlope(d, n0, n1, n), along_m = meanSlope(d, m0, m1, m);
  const double cosine = n.dot(m), sine2 = 1.0 - cosine * cosine;
  if (!along_n || !along_m || !(sine2 > least_sine * least_sine))
    return Vector3d::Zero();
  // The bow in the plane of n and m whose component along each is that of its surface.
  return (*along_n - cosine * *along_m) / sine2 * n + (*along_m - cosine * *along_n) / sine2 * m;
}

double
parabolaCrossing(double v0, double v1, double bow, double level)
{
  // v0 - level + (v1 - v0 - bow) u + bow u^2 = 0; the root between two ends of different sign, without cancellation.
  const double a = bow, b = v1 - v0 - bow, c = v0 - level;
  const double root = std::sqrt(std::max(0.0, b * b - 4.0 * a * c));
  const double q = v1 > v0 ? b + root : b - root; // has the sign of v1 - v0
  const double u = q != 0.0 ? -2.0 * c / q : (level - v0) / (v1 - v0);
  return std::min(1.0, std::max(0.0, u));
}

} // namespace pcl_spiral
