// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Surfaces given as heights over the x-y plane.
 */
#pragma once

#include "support/surfaces.h"

#include <cmath>

namespace pcl_spiral::test {

/** z = f(x, y); chart x, y. Derived classes give f with its first and second derivatives. */
class HeightField : public AnalyticSurface {
public:
  using AnalyticSurface::AnalyticSurface;
  struct Jet {
    double f, fx, fy, fxx, fxy, fyy;
  };
  virtual Jet jet(double x, double y) const = 0;

  double value(const Eigen::Vector3d& x) const override { return x.z() - jet(x.x(), x.y()).f; }
  Eigen::Vector3d gradient(const Eigen::Vector3d& x) const override
  {
    const Jet j = jet(x.x(), x.y());
    return {-j.fx, -j.fy, 1.0};
  }
  Eigen::Matrix3d hessian(const Eigen::Vector3d& x) const override
  {
    const Jet j = jet(x.x(), x.y());
    Eigen::Matrix3d h = Eigen::Matrix3d::Zero();
    h(0, 0) = -j.fxx;
    h(0, 1) = h(1, 0) = -j.fxy;
    h(1, 1) = -j.fyy;
    return h;
  }
  Eigen::Vector3d lift(const Eigen::Vector2d& u) const override { return {u.x(), u.y(), jet(u.x(), u.y()).f}; }
  Eigen::Vector2d chart(const Eigen::Vector3d& x) const override { return x.head<2>(); }
  double areaElement(const Eigen::Vector2d& u) const override
  {
    const Jet j = jet(u.x(), u.y());
    return std::sqrt(1.0 + j.fx * j.fx + j.fy * j.fy);
  }
};

} // namespace pcl_spiral::test
