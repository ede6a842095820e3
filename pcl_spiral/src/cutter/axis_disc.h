// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Axes about a given one, on a lattice. Private.
 */
#pragma once

#include <Eigen/Core>

#include <vector>

namespace pcl_spiral {

/** Turns of an axis by up to a largest angle: places of a square lattice in a disc, radians to either side. The first is no turn; then
 *  by their angle. */
class AxisDisc {
public:
  AxisDisc(double most, int rings);

  std::size_t size() const { return turns_.size(); }
  double spacing() const { return spacing_; }
  const Eigen::Vector2d& operator[](std::size_t k) const { return turns_[k]; }
  /** The turn nearest to \p turn. */
  std::size_t nearest(const Eigen::Vector2d& turn) const;

private:
  double spacing_;
  std::vector<Eigen::Vector2d> turns_;
};

/** An axis, and two unit directions across it, which follow it along a pass without turning about it. */
struct AxisWithSides {
  Eigen::Vector3d axis, e1, e2;

  explicit AxisWithSides(const Eigen::Vector3d& axis);
  /** The frame moved to \p next, by the shortest turn. */
  AxisWithSides movedTo(const Eigen::Vector3d& next) const;
  /** The axis turned by \p turn. Of two turns the axes differ by no more than the turns do. */
  Eigen::Vector3d turned(const Eigen::Vector2d& turn) const;
};

} // namespace pcl_spiral
