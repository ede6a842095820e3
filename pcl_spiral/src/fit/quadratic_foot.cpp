// SPDX-License-Identifier: BSD-3-Clause
#include "local_fit.h"
#include "normal_equations.h"
#include "patch_moments.h"
#include "quadric.h"

#include <pcl_spiral/core/impl/frame.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {

SurfaceFoot
quadraticFoot(const Eigen::Vector3d& query, const Patch& patch, const Eigen::Vector3d& up)
{
  SurfaceFoot foot;
  foot.position = query;
  foot.normal = up;
  const double radius = std::sqrt(static_cast<double>(patch.squared_radius));
  Eigen::Vector3d e1, e2;
  tangentFrame(up, e1, e2);
  Eigen::Matrix3f frame;
  frame << (e1 / radius).cast<float>(), (e2 / radius).cast<float>(), (up / radius).cast<float>();
  Moments s;
  momentsOf(patch, frame.data(), s);
  foot.overhang = overhang(patch, s.mean_u * e1 + s.mean_v * e2);
  Eigen::Matrix<double, 6, 6> a;
  a << s.w, s.u, s.v, s.uu, s.uv, s.vv,           //
      s.u, s.uu, s.uv, s.uuu, s.uuv, s.uvv,       //
      s.v, s.uv, s.vv, s.uuv, s.uvv, s.vvv,       //
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
