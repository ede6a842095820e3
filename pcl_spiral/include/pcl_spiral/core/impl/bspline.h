// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Cubic B-spline curve in space, with its arc length.
 */
#pragma once

#include <pcl_spiral/core/impl/polyline.h>

#include <array>

namespace pcl_spiral {

/** A clamped cubic B-spline curve: it starts in the first control point and ends in the last.
 *
 *  Parameters outside [firstParameter, lastParameter] and lengths outside [0, length] are moved to the nearer
 * end. Derivatives are with respect to the parameter u; a curve made by fitBSpline has |c'(u)| close to 1.
 *  Evaluation: local polynomials from the Bezier form of each span (blossoms; de Boor 1972). Arc length:
 *  five-point Gauss-Legendre quadrature, each span halved until both halves agree with the whole to 1e-12.
 * Lengths in the unit of the control points. */
class BSplineCurve {
public:
  /** An empty curve: length 0, every point at the origin. */
  BSplineCurve() = default;

  /** \param knots ascending; first and last four equal, at most simple inside; control_points.size() + 4 of
   * them. \param control_points at least four. \throws std::invalid_argument if these do not match. */
  BSplineCurve(std::vector<double> knots, Polyline control_points);

  const std::vector<double>& knots() const { return knots_; }
  const Polyline& controlPoints() const { return control_points_; }
  std::size_t spans() const { return polynomials_.size(); }
  double firstParameter() const { return breaks_.empty() ? 0.0 : breaks_.front(); }
  double lastParameter() const { return breaks_.empty() ? 0.0 : breaks_.back(); }

  Eigen::Vector3d position(double u) const;
  Eigen::Vector3d derivative(double u) const;
  Eigen::Vector3d secondDerivative(double u) const;

  /** Whole arc length. */
  double length() const { return lengths_.empty() ? 0.0 : lengths_.back(); }
  /** Arc length from the start to parameter \p u. */
  double arcLength(double u) const;
  /** Parameter at arc length \p s from the start: the inverse of arcLength, to 1e-12 of the length. */
  double parameterAt(double s) const;
  /** Point at arc length \p s. */
  Eigen::Vector3d positionAt(double s) const { return position(parameterAt(s)); }
  /** Unit tangent at arc length \p s; zero where the derivative is zero. */
  Eigen::Vector3d tangentAt(double s) const { return derivative(parameterAt(s)).normalized(); }

private:
  /** Position is a0 + t (a1 + t (a2 + t a3)), t = u - start of the span. */
  using Polynomial = std::array<Eigen::Vector3d, 4>;

  std::size_t span(double& u) const;
  double lengthBetween(std::size_t span, double u0, double u1) const;
  void addLengths(std::size_t span, double u0, double u1, double whole, int depth);

  std::vector<double> knots_;
  Polyline control_points_;
  std::vector<double> breaks_; ///< distinct knots, spans() + 1
  std::vector<Polynomial> polynomials_;
  std::vector<double> stations_; ///< parameters of the arc length table; every break is one of them
  std::vector<double> lengths_;  ///< arc length at the stations
};

} // namespace pcl_spiral
