// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/core/impl/step_over_metric.h>
#include <pcl_spiral/core/step_over.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>

namespace pcl_spiral {

double
longestStepOver(const StepOverMetric& metric)
{
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(metric.matrix(), Eigen::EigenvaluesOnly);
  return 1.0 / std::sqrt(std::max(solver.eigenvalues()[0], 1e-12));
}

double
longestStepOverBound(const StepOverMetric& metric)
{
  constexpr double rounding = 1e-6; // of the determinant, where eigenvalues differ by less than a factor of 10^4
  const Eigen::Matrix3d g = metric.matrix();
  const double determinant = g.determinant(), trace = g.trace(), minors = 0.5 * (trace * trace - g.squaredNorm());
  const double root = std::sqrt(std::max(0.0, 4.0 * minors * minors - 12.0 * trace * determinant));
  const double least = 3.0 * determinant / (minors + root);
  return 1.0 / std::sqrt(std::max((1.0 - rounding) * least, 1e-12));
}

StepOverMetric
stepOverMetric(const Eigen::Vector3d& normal, const Eigen::Vector3d& direction1, double k1, double k2, double radius, double scallop_height)
{
  const double flat = 1.0 / radius;
  const Eigen::Vector3d direction2 = normal.cross(direction1);
  const double g1 = spacingCurvature(radius, k1) + flat, g2 = spacingCurvature(radius, k2) + flat;
  const Eigen::Matrix3d g =
      g1 * direction1 * direction1.transpose() + g2 * direction2 * direction2.transpose() + flat * normal * normal.transpose();
  return StepOverMetric(Eigen::Matrix3d(g / (8.0 * scallop_height * (1.0 - 0.5 * scallop_height / radius))));
}

} // namespace pcl_spiral
