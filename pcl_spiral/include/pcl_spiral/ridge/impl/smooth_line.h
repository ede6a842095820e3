// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A smooth curve through a measured line.
 */
#pragma once

#include <pcl_spiral/core/bspline_fit.h>
#include <pcl_spiral/ridge/impl/measured_line.h>

namespace pcl_spiral {

/** A curve by its arc length s, in mm: from 0 to length(); on a closed curve any s, round after round. */
class SmoothLine {
public:
  SmoothLine() = default;
  /** The part of \p curve between the arc lengths \p begin and \p end; if \p closed, that is one round. */
  SmoothLine(BSplineCurve curve, double begin, double end, bool closed);

  double length() const { return end_ - begin_; }
  bool closed() const { return closed_; }

  Eigen::Vector3d position(double s) const;
  /** Unit. */
  Eigen::Vector3d tangent(double s) const;
  /** Derivative of the unit tangent by the arc length: towards the centre of the circle of curvature, 1/mm. */
  Eigen::Vector3d curvature(double s) const;
  /** Arc length of the place nearest to \p p. */
  double nearest(const Eigen::Vector3d& p) const;
  SmoothLine reversed() const;
  /** A closed line whose arc length starts at the place at \p s. */
  SmoothLine startingAt(double s) const;

private:
  double parameterAt(double s) const;

  BSplineCurve curve_;
  double begin_ = 0.0, end_ = 0.0;
  double shift_ = 0.0; ///< of a closed line: where its arc length begins, measured from begin_
  bool closed_ = false;
};

/** A curve fitted to a line. */
struct LineFit {
  SmoothLine line;
  double error = 0.0;    ///< standard deviation of a coordinate about the curve, mm
  std::size_t spans = 0; ///< of the B-spline, in the whole line or in one round
};

/** Least-squares cubic B-spline. Its number of spans is the one that best predicts points left out of the fit, by generalised cross
 *  validation (Craven, Wahba 1979). Fewer spans are used if they leave no more than the measuring error \p error, the standard deviation
 *  of a coordinate; 0: not known. A closed line is fitted with half a round more at each end, so that its curve continues where it began.
 *  Points closer than 30 times the error are averaged first, down to 40 points; that uses the spacing of the line; 0: no averaging. */
LineFit fitLine(const MeasuredLine& measured, double error = 0.0);

/** How well the direction of a curve through the points is known, rms in degrees: half the
 *  difference between the curves through every second point. 0 for fewer than 16 points. */
double directionError(const MeasuredLine& measured);

} // namespace pcl_spiral
