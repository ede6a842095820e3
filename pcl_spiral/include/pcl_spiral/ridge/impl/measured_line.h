// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A line measured point by point, put in order.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/core/polyline.h>

#include <cstddef>

namespace pcl_spiral {

/** Points of one line, in their order along it. */
struct MeasuredLine {
  Polyline points;      ///< on a closed line the first point is not repeated
  bool closed = false;  ///< its ends are no farther apart than twice the median spacing
  double spacing = 0.0; ///< median distance between neighbours, mm
};

/** Puts \p points in order, from any input order, by the tree of least total length that joins
 *  them: the tree of a line is the line itself. Do not rely on the end at which it begins. Duplicate
 *  points are left out. Messages use \p name. Time grows with the square of the number of points.
 *
 *  InvalidInput, with the place: fewer than four points or more than 20,000; a point that is not finite; a gap of more than five spacings;
 *  a branch of the tree longer than five spacings. Shorter branches, which noise causes where points are close, become part of the line. */
Status orderLine(const Polyline& points, const Diagnostic& name, MeasuredLine& line);

} // namespace pcl_spiral
