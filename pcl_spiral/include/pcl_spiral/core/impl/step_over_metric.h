// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Lengths along a surface in step-overs.
 */
#pragma once

#include <Eigen/Core>

#include <array>
#include <cmath>

namespace pcl_spiral {

/** A quadratic form: a small move across the feed has the length 1 if it is one step-over. Symmetric; units
 *  1/mm2. Single precision: 24 bytes per point of a surface. */
class StepOverMetric {
public:
  StepOverMetric() = default;
  explicit StepOverMetric(const Eigen::Matrix3d& g)
  : g_{static_cast<float>(g(0, 0)), static_cast<float>(g(1, 1)), static_cast<float>(g(2, 2)),
       static_cast<float>(g(0, 1)), static_cast<float>(g(0, 2)), static_cast<float>(g(1, 2))}
  {}

  double squaredLength(const Eigen::Vector3d& d) const
  {
    return g_[0] * d.x() * d.x() + g_[1] * d.y() * d.y() + g_[2] * d.z() * d.z() +
           2.0 * (g_[3] * d.x() * d.y() + g_[4] * d.x() * d.z() + g_[5] * d.y() * d.z());
  }
  /** Length of the move \p d, mm, in step-overs. */
  double length(const Eigen::Vector3d& d) const { return std::sqrt(std::max(0.0, squaredLength(d))); }

  Eigen::Matrix3d matrix() const
  {
    Eigen::Matrix3d m;
    m << g_[0], g_[3], g_[4], g_[3], g_[1], g_[5], g_[4], g_[5], g_[2];
    return m;
  }

  /** This metric times \p share; sums of such shares are weighted means. */
  StepOverMetric times(double share) const
  {
    StepOverMetric scaled;
    for (std::size_t i = 0; i < 6; ++i)
      scaled.g_[i] = static_cast<float>(share * g_[i]);
    return scaled;
  }
  StepOverMetric& operator+=(const StepOverMetric& other)
  {
    for (std::size_t i = 0; i < 6; ++i)
      g_[i] += other.g_[i];
    return *this;
  }

private:
  std::array<float, 6> g_{}; ///< xx, yy, zz, xy, xz, yz
};

/** The metric at \p share of the way from \p a to \p b. */
inline StepOverMetric
between(const StepOverMetric& a, const StepOverMetric& b, double share)
{
  StepOverMetric m = a.times(1.0 - share);
  return m += b.times(share);
}

/** The largest length in mm of a move of one step-over: 1 / sqrt of the least eigenvalue. */
double longestStepOver(const StepOverMetric& metric);

/** No less than longestStepOver, and at most 2 / sqrt(3) times it, in a tenth of the time: for searches that look this far. By one step
 *  of Laguerre's method (1880) from zero: where all roots of a polynomial are real, it does not pass the first. */
double longestStepOverBound(const StepOverMetric& metric);

/** Metric of a ball of \p radius that leaves \p scallop_height. There the surface has the unit \p normal and the principal
 *  curvatures k1 along \p direction1 and k2 across it, 1/mm, positive where convex:
 *
 *    G = (k1 + 1/R) d1 d1' + (k2 + 1/R) d2 d2' + (1/R) n n',   divided by 8 h (1 - h / 2R).
 *
 *  On a plane one step-over is exactly 2 sqrt(2 R h - h^2). On a curved surface it is that of stepOverFirstOrder with the plane's
 *  second-order term. Curvatures are those of spacingCurvature: where the ball hardly fits, step-overs are at most
 *  4.5 times those of a plane. */
StepOverMetric stepOverMetric(const Eigen::Vector3d& normal, const Eigen::Vector3d& direction1, double k1, double k2, double radius,
                              double scallop_height);

} // namespace pcl_spiral
