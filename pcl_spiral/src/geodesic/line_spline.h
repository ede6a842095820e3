// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A smooth curve through the points of a line.
 */
#pragma once

#include <pcl_spiral/core/polyline.h>

namespace pcl_spiral {

/** Interpolating cubic spline over chord length; its second derivative continues straight into the end segments. */
class LineSpline {
public:
  explicit LineSpline(const Polyline& points);

  double length() const { return lengths_.back(); }
  /** \p count points at equal arc length, the ends exactly. */
  Polyline resampled(std::size_t count) const;

private:
  Eigen::Vector3d derivative(std::size_t segment, double f) const;
  Eigen::Vector3d position(std::size_t segment, double f) const;

  const Polyline& points_;
  std::vector<double> chords_;  ///< of each segment
  Polyline second_;             ///< second derivative at each point
  std::vector<double> lengths_; ///< arc length up to each point
};

} // namespace pcl_spiral
