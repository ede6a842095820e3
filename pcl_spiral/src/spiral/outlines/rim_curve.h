// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A boundary loop as a curve by arc length. Private.
 */
#pragma once

#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/features/boundary_loop.h>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** A closed curve with its arc lengths, starting where line 0 ends. */
class RimCurve {
public:
  RimCurve(const BoundaryLoop& loop, const Eigen::Vector3d& start);

  double length() const { return s_.back(); }
  const Polyline& points() const { return points_; }
  const std::vector<std::size_t>& corners() const { return corners_; }
  double arcLengthOf(std::size_t vertex) const { return s_[vertex]; }
  Eigen::Vector3d at(double s) const;

private:
  void startAt(const BoundaryLoop& loop, const Eigen::Vector3d& start);

  Polyline points_;
  std::vector<std::size_t> corners_;
  std::vector<double> s_;
};

} // namespace pcl_spiral
