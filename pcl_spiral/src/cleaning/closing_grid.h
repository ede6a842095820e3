// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The surface that a ball coming down along one direction can touch, on a grid. Private to cleaning.
 */
#pragma once

#include <pcl_spiral/cleaning/impl/drop_ball.h>
#include <pcl_spiral/core/height_grid.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** A surface closed along the fall of a ball, at the nodes of a square grid: the closing of the points of a DropBall by its ball, dilation,
 *  then erosion (Serra 1982, Image Analysis and Mathematical Morphology). It is the lowest surface over all points of which every place can
 *  be touched, but for walls: nobody saw them, and the surface of the centres is no steeper than steepest_tangent. Lengths in mm. */
class ClosingGrid {
public:
  /** \p cell: distance of the nodes, mm, which lie at multiples of it. */
  ClosingGrid(const DropBall& ball, double cell);

  std::int64_t columns() const { return columns_; }
  std::int64_t rows() const { return rows_; }
  double cell() const { return cell_; }
  std::size_t size() const { return heights_.size(); }
  std::size_t node(std::int64_t column, std::int64_t row) const { return static_cast<std::size_t>(row * columns_ + column); }
  /** Height of the surface at a node that has it. */
  double height(std::size_t node) const { return heights_[node]; }
  /** Whether there is a surface. Never at the outermost nodes. */
  bool has(std::size_t node) const { return heights_[node] > -infinite; }
  double u(std::int64_t column) const { return low_.x() + static_cast<double>(column) * cell_; }
  double v(std::int64_t row) const { return low_.y() + static_cast<double>(row) * cell_; }
  /** Raises the surface by a ball of \p radius, mm, that rolls on it: edges are then no sharper than that. */
  void offset(double radius);
  /** Leaves out what the ball cannot touch because of the further points that \p all was made of, with the same cell. */
  void leaveOut(const ClosingGrid& all);
  /** The least height at the corners of the cell of (\p u, \p v), which lies between the outermost points. */
  double lowestAbout(double u, double v) const;

private:
  static constexpr double infinite = 1e300;

  void dilate(const DropBall& ball);
  void erode();
  /** Calls \p visit(to, from, count, rise) for runs of nodes that lie beside each other, \p rise on a sphere of \p radius over \p from. */
  template <typename Visit>
  void overBall(std::int64_t row, double radius, Visit visit) const;
  void limitSlope();

  double cell_, radius_;
  std::int64_t reach_ = 0; ///< cells in a radius
  Eigen::Vector2d low_;
  std::int64_t columns_ = 0, rows_ = 0;
  std::vector<double> centres_; ///< heights of the ball that touches, at the nodes
  std::vector<double> heights_;
};

} // namespace pcl_spiral
