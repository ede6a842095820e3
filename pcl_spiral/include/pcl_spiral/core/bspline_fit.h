// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Cubic B-spline curves, and their fit to a sequence of points by least squares.
 */
#pragma once

#include <pcl_spiral/core/polyline.h>

#include <array>
#include <optional>

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

  const std::vector<double>& knots() const { return knots_; }                       ///< Ascending, with multiplicity.
  const Polyline& controlPoints() const { return control_points_; }                 ///< Control points in order.
  std::size_t spans() const { return polynomials_.size(); }                         ///< Number of polynomial pieces; 0 for an empty curve.
  double firstParameter() const { return breaks_.empty() ? 0.0 : breaks_.front(); } ///< Parameter at the start.
  double lastParameter() const { return breaks_.empty() ? 0.0 : breaks_.back(); }   ///< Parameter at the end.

  Eigen::Vector3d position(double u) const;         ///< Point at parameter \p u.
  Eigen::Vector3d derivative(double u) const;       ///< First derivative at parameter \p u.
  Eigen::Vector3d secondDerivative(double u) const; ///< Second derivative at parameter \p u.

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

/** Options of a B-spline fit. Lengths in the unit of the points. */
struct BSplineFitOptions {
  double tolerance = 1e-3;   ///< spans are doubled, up to one for two points, until no point is farther away than this
  std::size_t min_spans = 4; ///< spans to start with
  std::size_t max_spans = 0; ///< 0: points - 3, which interpolates and is tried last
};

/** A fitted curve, and the distance of its points from it. */
struct BSplineFit {
  BSplineCurve curve;            ///< over chord length
  double max_deviation = 0.0;    ///< largest distance of a point from the curve at its own parameter
  double rms_deviation = 0.0;    ///< rms of these distances
  bool within_tolerance = false; ///< whether the largest distance is within BSplineFitOptions::tolerance
};

/** Least-squares cubic B-spline over chord length; both ends are interpolated exactly.
 *
 *  Parameters are the chord lengths of the points. Knots are at equal lengths, or at equal shares of the
 * points (Piegl and Tiller 1997, equations 9.69 and 9.8) if a span would contain no point. The normal
 * equations have seven diagonals and are solved in this form, in time proportional to the number of points. The
 * deviation is an upper bound of the true distance, because it is measured at the point's own parameter. Points
 * equal to their neighbour are skipped. Two or three points give a line or a parabola. \return nullopt
 * if fewer than two points differ, a point is not finite, or the tolerance is not positive. */
std::optional<BSplineFit> fitBSpline(const Polyline& points, const BSplineFitOptions& options = {});

} // namespace pcl_spiral
