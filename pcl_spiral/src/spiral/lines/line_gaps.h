// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Places of radial lines on the rim, and lines predicted in the gaps between them. Private.
 */
#pragma once

#include "spiral/outlines/rim_curve.h"

#include <pcl_spiral/spiral/radial_line.h>

#include <limits>
#include <vector>

namespace pcl_spiral {

/** A planned line: its place on the rim, and the errors known in the gap after it. */
struct LinePlace {
  double s; ///< arc length on the rim
  bool corner;
  int level;
  double misfit = std::numeric_limits<double>::infinity();   ///< error in the gap when it was twice as wide, mm
  double surprise = std::numeric_limits<double>::infinity(); ///< the same with the part that comes from the rim, mm
};

/** Corners, and between them places at equal distances, about 32 in all. */
std::vector<LinePlace> coarsePlaces(const RimCurve& rim);

/** The gap after a line: the place that halves it, and the line predicted there from the lines about it by Lagrange's cubic, or a
 *  lower polynomial beside corners. */
class LineGap {
public:
  LineGap(const std::vector<LinePlace>& places, const RimCurve& rim, std::size_t i);

  double width() const { return width_; }
  double middle() const { return middle_; }

  /** Largest distance between the rim within the gap and the rim predicted from the ends of the lines. */
  double rimError(const RimCurve& rim) const;
  /** The whole line in the middle, up to the rim. */
  Polyline predicted(const std::vector<RadialLine>& lines, const RimCurve& rim) const;
  /** Largest distance between the line found in the middle and the predicted one; \p misfit: the same without the part
   *  that comes from the shape of the rim, which lines follow in proportion to their length. */
  double surprise(const std::vector<RadialLine>& lines, const RadialLine& found, double& misfit) const;

private:
  std::vector<double> weights(double s) const;
  Eigen::Vector3d predictedAt(const std::vector<RadialLine>& lines, const std::vector<double>& weights, std::size_t station) const;

  std::vector<std::size_t> lines_;
  std::vector<double> s_; ///< of these lines on the rim, ascending
  double begin_, width_, middle_;
};

} // namespace pcl_spiral
