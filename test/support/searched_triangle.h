// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Triangles under a cutter, and the height of the cutter on them by search.
 */
#pragma once

#include "support/cutters.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace pcl_spiral::test {

/** The maximum of a concave function on [0, 1]. */
template <typename Function>
double
largest(const Function& f)
{
  constexpr double golden = 0.6180339887498949;
  double a = 0.0, b = 1.0, x = 1.0 - golden, y = golden, fx = f(x), fy = f(y);
  double best = std::max({f(0.0), f(1.0), fx, fy});
  for (int i = 0; i < 70; ++i) {
    if (fx < fy) {
      a = x, x = y, fx = fy;
      y = a + golden * (b - a), fy = f(y);
    }
    else {
      b = y, y = x, fy = fx;
      x = b - golden * (b - a), fx = f(x);
    }
    best = std::max({best, fx, fy});
  }
  return best;
}

/** Height of the cutter on a triangle seen along its axis, by golden section inside golden section; beyond the
 *  cutter the profile rises steeply instead of ending. */
inline double
searched(const Eigen::Matrix3d& c, const CutterProfile& cutter, double steep)
{
  const double R = cutter.radius();
  return largest([&](double t) {
    const Eigen::Vector3d a = (1.0 - t) * c.col(0) + t * c.col(1), b = (1.0 - t) * c.col(0) + t * c.col(2);
    return largest([&](double u) {
      const Eigen::Vector3d p = (1.0 - u) * a + u * b;
      const double l = p.head<2>().norm();
      return p.z() - cutter.height(std::min(l, R)) - steep * std::max(0.0, l - R);
    });
  });
}

/** Random corners round a cutter of radius \p R: of any size, some level, upright, thin, or round the axis. */
inline Eigen::Matrix3d
randomTriangle(double R, Random& random)
{
  const double size = R * std::pow(10.0, random.uniform(-2.0, 0.7));
  Eigen::Vector3d middle(random.uniform(-1.2, 1.2) * R, random.uniform(-1.2, 1.2) * R, random.uniform(-5.0, 5.0));
  const auto kind = random.below(8);
  if (kind == 0)
    middle.head<2>().setZero();
  Eigen::Matrix3d c;
  for (int k = 0; k < 3; ++k)
    c.col(k) = middle + size * Eigen::Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  if (kind == 1)
    c.row(2).setConstant(middle.z());
  if (kind == 2)
    c.row(1).setConstant(middle.y());
  if (kind == 3)
    c.col(2).head<2>() = c.col(1).head<2>();
  if (kind == 4)
    c.col(2) = 0.5 * (c.col(0) + c.col(1)) + 1e-4 * size * Eigen::Vector3d(0.3, -0.8, 0.5);
  return c;
}

} // namespace pcl_spiral::test
