// SPDX-License-Identifier: BSD-3-Clause
#include "local_shape.h"

#include "core/lanes.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl_spiral {
namespace {

/** Unit eigenvector of a covariance's smallest eigenvalue. Newton's method finds that root of the characteristic polynomial,
 *  starting from zero, where it falls towards the root; then the columns of the adjugate are multiples of the vector. */
Eigen::Vector3d
leastAxis(const Eigen::Matrix3d& c)
{
  constexpr int most_iterations = 16;
  const double trace = c.trace(), determinant = c.determinant();
  const double minors =
      c(0, 0) * c(1, 1) + c(0, 0) * c(2, 2) + c(1, 1) * c(2, 2) - c(0, 1) * c(0, 1) - c(0, 2) * c(0, 2) - c(1, 2) * c(1, 2);
  double root = 0.0;
  for (int i = 0; i < most_iterations; ++i) {
    const double slope = (2.0 * trace - 3.0 * root) * root - minors;
    if (!(slope < 0.0))
      break;
    const double step = (((trace - root) * root - minors) * root + determinant) / slope;
    root -= step;
    if (std::abs(step) <= 1e-13 * trace)
      break;
  }
  const Eigen::Matrix3d m = c - root * Eigen::Matrix3d::Identity();
  const std::array<Eigen::Vector3d, 3> columns{m.col(1).cross(m.col(2)), m.col(2).cross(m.col(0)), m.col(0).cross(m.col(1))};
  const auto largest =
      std::max_element(columns.begin(), columns.end(), [](const auto& a, const auto& b) { return a.squaredNorm() < b.squaredNorm(); });
  const double norm = largest->norm();
  if (norm > 1e-6 * trace * trace)
    return *largest / norm;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver; // points on a line, or in all directions
  solver.computeDirect(c);
  return solver.eigenvectors().col(0);
}

} // namespace

LocalShape
localShape(const Neighbourhood& near)
{
  using Lane = Eigen::Array<float, lane_count, 1>;
  Lane x1 = Lane::Zero(), y1 = x1, z1 = x1, xx = x1, xy = x1, xz = x1, yy = x1, yz = x1, zz = x1;
  for (int j = 0; j < near.size; j += lane_count) {
    const Lane x = Eigen::Map<const Lane>(near.x + j), y = Eigen::Map<const Lane>(near.y + j), z = Eigen::Map<const Lane>(near.z + j);
    x1 += x;
    y1 += y;
    z1 += z;
    xx += x * x;
    xy += x * y;
    xz += x * z;
    yy += y * y;
    yz += y * z;
    zz += z * z;
  }
  const Eigen::Vector3d mean = Eigen::Vector3d(x1.sum(), y1.sum(), z1.sum()) / near.size;
  Eigen::Matrix3d moment;
  moment << xx.sum(), xy.sum(), xz.sum(), xy.sum(), yy.sum(), yz.sum(), xz.sum(), yz.sum(), zz.sum();
  const Eigen::Vector3d normal = leastAxis(moment / near.size - mean * mean.transpose());
  const double radius = std::sqrt(static_cast<double>(near.squared_distance[near.size - 1])), height = -mean.dot(normal);
  return {normal, radius, height, radius > 0.0 ? (mean + height * normal).norm() / radius : 0.0};
}

} // namespace pcl_spiral
