#include "local_fit.h"

#include <pcl_spiral/core/frame.h>

#include <cmath>

namespace pcl_spiral {
namespace {

/** Weighted moments of the neighbours, coordinates over their radius. */
struct Moments {
  float w = 0;
  float u = 0, v = 0, uu = 0, uv = 0, vv = 0, uuu = 0, uuv = 0, uvv = 0, vvv = 0;
  float uuuu = 0, uuuv = 0, uuvv = 0, uvvv = 0, vvvv = 0;
  float f = 0, fu = 0, fv = 0, fuu = 0, fuv = 0, fvv = 0, ff = 0;
  float mean_u = 0, mean_v = 0; ///< unweighted
};

Moments
momentsOf(const Neighbourhood& near, const Eigen::Vector3f& e1, const Eigen::Vector3f& e2, const Eigen::Vector3f& up,
          float scale)
{
  float w = 0, su = 0, sv = 0, uu = 0, uv = 0, vv = 0, uuu = 0, uuv = 0, uvv = 0, vvv = 0;
  float uuuu = 0, uuuv = 0, uuvv = 0, uvvv = 0, vvvv = 0;
  float f = 0, fu = 0, fv = 0, fuu = 0, fuv = 0, fvv = 0, ff = 0, mean_u = 0, mean_v = 0;
  const float *x = near.x, *y = near.y, *z = near.z;
#pragma omp simd reduction(+ : w, su, sv, uu, uv, vv, uuu, uuv, uvv, vvv, uuuu, uuuv, uuvv, uvvv, vvvv, f, fu, fv, \
                               fuu, fuv, fvv, ff, mean_u, mean_v)
  for (int j = 0; j < near.size; ++j) {
    const float a = (x[j] * e1[0] + y[j] * e1[1] + z[j] * e1[2]) * scale;
    const float b = (x[j] * e2[0] + y[j] * e2[1] + z[j] * e2[2]) * scale;
    const float h = (x[j] * up[0] + y[j] * up[1] + z[j] * up[2]) * scale;
    const float inside = std::max(0.0f, 1.0f - (a * a + b * b));
    const float weight = inside * inside * inside;
    const float wa = weight * a, wb = weight * b, waa = wa * a, wab = wa * b, wbb = wb * b;
    mean_u += a, mean_v += b;
    w += weight;
    su += wa, sv += wb, uu += waa, uv += wab, vv += wbb;
    uuu += waa * a, uuv += waa * b, uvv += wab * b, vvv += wbb * b;
    uuuu += waa * a * a, uuuv += waa * a * b, uuvv += waa * b * b, uvvv += wab * b * b, vvvv += wbb * b * b;
    f += weight * h, fu += wa * h, fv += wb * h, fuu += waa * h, fuv += wab * h, fvv += wbb * h;
    ff += weight * h * h;
  }
  const auto n = static_cast<float>(near.size);
  return {w,    su,   sv, uu, uv, vv,  uuu, uuv, uvv, vvv,        uuuu,      uuuv,
          uuvv, uvvv, vvvv, f,  fu, fv, fuu, fuv, fvv, ff,  mean_u / n, mean_v / n};
}

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

/** Solve A x = b by Cholesky, in place; false when a pivot vanishes against the first. */
bool
solveNormalEquations(Matrix6d& a, Vector6d& b)
{
  for (int i = 0; i < 6; ++i) {
    const double whole = a(i, i);
    for (int j = 0; j <= i; ++j) {
      double sum = a(i, j);
      for (int k = 0; k < j; ++k)
        sum -= a(i, k) * a(j, k);
      if (i != j)
        a(i, j) = sum / a(j, j);
      else if (!(sum > 1e-6 * whole)) // the column hardly differs from the ones before it
        return false;
      else
        a(i, i) = std::sqrt(sum);
    }
  }
  for (int i = 0; i < 6; ++i) {
    for (int k = 0; k < i; ++k)
      b[i] -= a(i, k) * b[k];
    b[i] /= a(i, i);
  }
  for (int i = 5; i >= 0; --i) {
    for (int k = i + 1; k < 6; ++k)
      b[i] -= a(k, i) * b[k];
    b[i] /= a(i, i);
  }
  return true;
}

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
shapeOfQuadric(const Vector6d& b, double u, double v, double radius, const Eigen::Vector3d& e1,
               const Eigen::Vector3d& e2, const Eigen::Vector3d& up, SurfaceFoot& foot)
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
  const double mean = 0.5 * (k11 + k22), half = 0.5 * (k11 - k22), spread = std::hypot(half, k12);
  foot.curvature1 = (mean + spread) / radius;
  foot.curvature2 = (mean - spread) / radius;
  const double angle = spread > 0.0 ? 0.5 * std::atan2(k12, half) : 0.0;
  foot.direction1 = std::cos(angle) * t1 + std::sin(angle) * t2;
}

} // namespace

SurfaceFoot
quadraticFoot(const Eigen::Vector3d& query, const Neighbourhood& near, const Eigen::Vector3d& up)
{
  SurfaceFoot foot;
  foot.position = query;
  foot.normal = up;
  const double radius = std::sqrt(static_cast<double>(near.squared_distance[near.size - 1]));
  Eigen::Vector3d e1, e2;
  tangentFrame(up, e1, e2);
  const Moments s = momentsOf(near, e1.cast<float>(), e2.cast<float>(), up.cast<float>(),
                              static_cast<float>(1.0 / radius));
  const Eigen::Vector3d centroid = radius * (s.mean_u * e1 + s.mean_v * e2);
  foot.overhang = overhang(near, centroid);
  Matrix6d a;
  a << s.w, s.u, s.v, s.uu, s.uv, s.vv,      //
      s.u, s.uu, s.uv, s.uuu, s.uuv, s.uvv,  //
      s.v, s.uv, s.vv, s.uuv, s.uvv, s.vvv,  //
      s.uu, s.uuu, s.uuv, s.uuuu, s.uuuv, s.uuvv, //
      s.uv, s.uuv, s.uvv, s.uuuv, s.uuvv, s.uvvv, //
      s.vv, s.uvv, s.vvv, s.uuvv, s.uvvv, s.vvvv;
  const Vector6d right = (Vector6d() << s.f, s.fu, s.fv, s.fuu, s.fuv, s.fvv).finished();
  Vector6d b = right;
  double u = 0.0, v = 0.0;
  if (!solveNormalEquations(a, b) || !nearestOnQuadric(b, u, v))
    return foot;
  const double f = b[0] + b[1] * u + b[2] * v + b[3] * u * u + b[4] * u * v + b[5] * v * v;
  foot.position = query + radius * (u * e1 + v * e2 + f * up);
  shapeOfQuadric(b, u, v, radius, e1, e2, up, foot);
  // The weighted sum of squares over its expectation for unit noise, sum w - tr((X'WX)^-1 X'W^2X); the trace is 15/7
  // for this weight on evenly spread neighbours.
  const double freedom = s.w - 15.0 / 7.0;
  foot.residual = freedom > 0.0 ? radius * std::sqrt(std::max(0.0, s.ff - b.dot(right)) / freedom) : 0.0;
  foot.valid = true;
  return foot;
}

} // namespace pcl_spiral
