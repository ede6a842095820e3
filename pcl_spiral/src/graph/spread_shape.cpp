// SPDX-License-Identifier: BSD-3-Clause
#include "spread_shape.h"

#include <pcl_spiral/core/impl/angles.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr double thin = 0.1; // second principal moment of a line, over the first

/** Sums over a point and its nearest neighbours. */
struct LineMoments {
  Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int points = 0;

  void addUpTo(const Neighbourhood& near, int count)
  {
    for (; points <= count; ++points) {
      const Eigen::Vector3d d(near.x[points], near.y[points], near.z[points]);
      sum += d;
      moment += d * d.transpose();
    }
  }

  /** Whether they lie along a line: the second principal moment is far below the first. This holds for at most one in ten of evenly
   *  spread random points. */
  bool areLine() const
  {
    const Eigen::Matrix3d about = moment - sum * sum.transpose() / points;
    // The second invariant over the square of the trace grows with both lesser moments.
    constexpr double most = thin * (2.0 + thin) / ((1.0 + 2.0 * thin) * (1.0 + 2.0 * thin));
    const double trace = about.trace();
    if (trace * trace - about.squaredNorm() > 2.0 * most * trace * trace)
      return false;
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    solver.computeDirect(about, Eigen::EigenvaluesOnly);
    return solver.eigenvalues()[1] < thin * solver.eigenvalues()[2];
  }
};

/** Whether the neighbours lie neither in a plane nor on a line, or the point lies off their plane or line. */
bool
isOff(const Neighbourhood& near, double spacing)
{
  constexpr double flat = 0.2, low = 0.7; // thickness over width; of the spacing
  Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  const int others = near.size - 1;
  for (int j = 1; j < near.size; ++j) {
    const Eigen::Vector3d d(near.x[j], near.y[j], near.z[j]);
    mean += d / others;
    moment += d * d.transpose();
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(moment - others * mean * mean.transpose());
  const Eigen::Vector3d& spread = solver.eigenvalues();
  if (spread[1] < thin * spread[2])
    return solver.eigenvectors().col(2).cross(mean).norm() > low * spacing;
  return spread[0] > flat * flat * spread[1] || std::abs(solver.eigenvectors().col(0).dot(mean)) > low * spacing;
}

} // namespace

SpreadShape
spreadShape(const Neighbourhood& near)
{
  // More neighbours show a line if noise moves points as far as they lie apart, or if two lines run side by side.
  constexpr int counts[] = {6, 12, 24};
  constexpr float nearly_one_place = 0.1f;
  const auto distance = [&](int j) { return std::sqrt(near.squared_distance[std::min(j, near.size - 1)]); };
  SpreadShape shape;
  shape.spacing = distance(near.size - 1) * std::sqrt(static_cast<float>(pi) / static_cast<float>(near.size));
  const int half = near.size / 2;
  shape.fine = distance(half - 1) * std::sqrt(static_cast<float>(pi) / static_cast<float>(half));
  shape.is_off = isOff(near, shape.spacing);
  shape.near = distance(8);
  shape.is_double = distance(1) < nearly_one_place * shape.spacing;
  shape.line_step = 0.0f;
  LineMoments moments;
  for (const int count : counts) {
    if (shape.is_off || near.size <= count)
      break;
    moments.addUpTo(near, count);
    if (moments.areLine())
      shape.line_step = std::max(shape.line_step, 2.0f * distance(count) / static_cast<float>(count));
  }
  return shape;
}

} // namespace pcl_spiral
