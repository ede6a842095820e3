/** \file
 *  A line measured point by point, put in order.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/core/impl/polyline.h>

#include <cstddef>
#include <string>

namespace pcl_spiral {

/** Points of one line in the order along it. */
struct MeasuredLine {
  Polyline points;      ///< of a closed line the first does not come again
  bool closed = false;  ///< its ends lie no farther apart than twice the median spacing
  double spacing = 0.0; ///< median distance of neighbours, mm
};

/** Put \p points in order, whatever order they come in, by the tree of least total length that joins them: a line's tree is the
 *  line. Which end it begins at is nothing to rely on. Repeated points are left out. \p name is said in messages.
 *  Time grows by the square of the number of points.
 *
 *  InvalidInput, with the place: fewer than four points or more than 20,000, one that is not finite, a gap of more than five spacings, a branch: a
 *  side way of the tree of more than five spacings. Shorter side ways, as noise makes them where points lie close, become part of the line. */
Status orderLine(const Polyline& points, const std::string& name, MeasuredLine& line);

} // namespace pcl_spiral
