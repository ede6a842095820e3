// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Cubic B-spline fitted to a sequence of points by least squares.
 */
#pragma once

#include <pcl_spiral/core/impl/bspline.h>

#include <optional>

namespace pcl_spiral {

/** Options of a B-spline fit. Lengths in the unit of the points. */
struct BSplineFitOptions {
  double tolerance = 1e-3;   ///< spans are doubled, up to one for two points, until no point is farther away than this
  std::size_t min_spans = 4; ///< spans to start with
  std::size_t max_spans = 0; ///< 0: points - 3, which interpolates and is tried last
};

/** A fitted curve, and the distance of its points from it. */
struct BSplineFit {
  BSplineCurve curve;
  double max_deviation = 0.0; ///< largest distance of a point from the curve at its own parameter
  double rms_deviation = 0.0;
  bool within_tolerance = false;
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
