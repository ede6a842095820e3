// SPDX-License-Identifier: BSD-3-Clause
#include "geodesic_steps.h"

#include "core/tridiagonal.h"
#include <pcl_spiral/core/impl/angles.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

/** Second derivative by arc length that a geodesic has at point \p i: along the normal. */
Vector3d
geodesicBending(const Polyline& points, const std::vector<SurfaceFoot>& feet, std::size_t i)
{
  const std::size_t before = i > 0 ? i - 1 : 0, after = std::min(i + 1, points.size() - 1);
  return -feet[i].normalCurvature((points[after] - points[before]).normalized()) * feet[i].normal;
}

/** M or its transpose, applied to the inner points; ends of \p x stay zero. */
class ProjectedSecondDifference {
public:
  ProjectedSecondDifference(const Polyline& points, const std::vector<SurfaceFoot>& feet) : feet_(feet)
  {
    for (std::size_t i = 1; i < points.size(); ++i)
      inverse_.push_back(1.0 / (points[i] - points[i - 1]).norm());
    difference_.resize(points.size());
    for (std::size_t i = 1; i + 1 < points.size(); ++i)
      difference_[i] = {inverse_[i - 1], -inverse_[i - 1] - inverse_[i], inverse_[i]};
  }
  Polyline apply(const Polyline& x) const
  {
    Polyline y(x.size(), Vector3d::Zero());
    for (std::size_t i = 1; i + 1 < x.size(); ++i) {
      const Vector3d bend = (x[i + 1] - x[i]) * inverse_[i] - (x[i] - x[i - 1]) * inverse_[i - 1];
      y[i] = bend - feet_[i].normal * feet_[i].normal.dot(bend);
    }
    return y;
  }
  Polyline applyTransposed(const Polyline& y) const
  {
    Polyline tangent(y.size(), Vector3d::Zero()), x(y.size(), Vector3d::Zero());
    for (std::size_t i = 1; i + 1 < y.size(); ++i)
      tangent[i] = y[i] - feet_[i].normal * feet_[i].normal.dot(y[i]);
    for (std::size_t i = 1; i + 1 < y.size(); ++i)
      x[i] = (tangent[i + 1] - tangent[i]) * inverse_[i] - (tangent[i] - tangent[i - 1]) * inverse_[i - 1];
    return x;
  }

  /** (K K)^-1 x: without it the condition of M^T M grows with the fourth power of the number of points. */
  Polyline precondition(const Polyline& x) const { return solveInnerPoints(difference_, solveInnerPoints(difference_, x)); }

private:
  const std::vector<SurfaceFoot>& feet_;
  std::vector<double> inverse_;            ///< of the segments' lengths
  std::vector<TridiagonalRow> difference_; ///< K
};

double
dot(const Polyline& x, const Polyline& y)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i)
    sum += x[i].dot(y[i]);
  return sum;
}

void
addScaled(Polyline& x, double factor, const Polyline& y)
{
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] += factor * y[i];
}

} // namespace

Polyline
tridiagonalStep(const Polyline& points, const std::vector<SurfaceFoot>& feet)
{
  const std::size_t n = points.size();
  const double whole = length(points), stiffest = 0.8 * std::pow(pi / whole, 2);
  Polyline conormals(n, Vector3d::Zero());
  std::vector<double> upper(n, 0.0), x(n, 0.0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    Vector3d before = points[i] - points[i - 1], after = points[i + 1] - points[i];
    const double f = before.norm(), g = after.norm(), w = 0.5 * (f + g);
    before /= f;
    after /= g;
    conormals[i] = feet[i].normal.cross(before + after).normalized();
    Vector3d turn = after - before;
    if (feet[i - 1].valid && feet[i + 1].valid)
      turn -= w / 12.0 * (geodesicBending(points, feet, i - 1) + geodesicBending(points, feet, i + 1));
    const double gauss = std::max(-1.0 / (w * w), std::min(stiffest, feet[i].gaussCurvature()));
    const double pivot = 1.0 / f + 1.0 / g - gauss * w - upper[i - 1] / f;
    upper[i] = 1.0 / (g * pivot);
    x[i] = (turn.dot(conormals[i]) + x[i - 1] / f) / pivot;
  }
  for (std::size_t i = n - 2; i-- > 1;)
    x[i] += upper[i] * x[i + 1];
  for (std::size_t i = 1; i + 1 < n; ++i)
    conormals[i] *= x[i];
  return conormals;
}

Polyline
conjugateGradientStep(const Polyline& points, const std::vector<SurfaceFoot>& feet)
{
  constexpr double accuracy = 1e-14; // of the gradient's square, in the preconditioner's norm
  const ProjectedSecondDifference matrix(points, feet);
  Polyline step(points.size(), Vector3d::Zero()), residual = matrix.apply(points);
  for (Vector3d& v : residual)
    v = -v;
  Polyline gradient = matrix.applyTransposed(residual), scaled = matrix.precondition(gradient), direction = scaled;
  double squared = dot(gradient, scaled);
  const double enough = accuracy * squared;
  for (std::size_t k = 0; k < 3 * points.size() && squared > enough; ++k) {
    const Polyline bent = matrix.apply(direction);
    const double alpha = squared / dot(bent, bent);
    if (!std::isfinite(alpha))
      break;
    addScaled(step, alpha, direction);
    addScaled(residual, -alpha, bent);
    gradient = matrix.applyTransposed(residual);
    scaled = matrix.precondition(gradient);
    const double before = squared;
    squared = dot(gradient, scaled);
    for (std::size_t i = 0; i < direction.size(); ++i)
      direction[i] = scaled[i] + squared / before * direction[i];
  }
  return step;
}

} // namespace pcl_spiral
