#include "local_fit.h"
#include "normal_equations.h"
#include "quadric.h"

#include <pcl_spiral/core/frame.h>

#include <algorithm>
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
  Eigen::Matrix<double, 6, 6> a;
  a << s.w, s.u, s.v, s.uu, s.uv, s.vv,      //
      s.u, s.uu, s.uv, s.uuu, s.uuv, s.uvv,  //
      s.v, s.uv, s.vv, s.uuv, s.uvv, s.vvv,  //
      s.uu, s.uuu, s.uuv, s.uuuu, s.uuuv, s.uuvv, //
      s.uv, s.uuv, s.uvv, s.uuuv, s.uuvv, s.uvvv, //
      s.vv, s.uvv, s.vvv, s.uuvv, s.uvvv, s.vvvv;
  const Vector6d right = (Vector6d() << s.f, s.fu, s.fv, s.fuu, s.fuv, s.fvv).finished();
  const NormalEquations<6> equations(a);
  if (equations.determined() < 6)
    return foot;
  const Vector6d b = equations.solve<6>(right);
  if (!standOnQuadric(b, radius, e1, e2, up, foot))
    return foot;
  // The weighted sum of squares over its expectation for unit noise, sum w - tr((X'WX)^-1 X'W^2X); the trace is 15/7
  // for this weight on evenly spread neighbours.
  const double freedom = s.w - 15.0 / 7.0;
  foot.residual = freedom > 0.0 ? radius * std::sqrt(std::max(0.0, s.ff - b.dot(right)) / freedom) : 0.0;
  foot.valid = true;
  return foot;
}

} // namespace pcl_spiral
