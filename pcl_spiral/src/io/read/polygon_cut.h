// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Polygons cut into triangles.
 */
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** Indices of three corners of a polygon. */
using CutTriangle = std::array<std::size_t, 3>;

/** A polygon of three or more corners, seen along its normal. */
class PolygonCut {
public:
  explicit PolygonCut(const std::vector<Eigen::Vector3d>& corners);

  /** Whether every corner turns the same way, by more than rounding errors, and all together once round. */
  bool convex() const;
  /** Triangles from the first corner. */
  std::vector<CutTriangle> fan() const;
  /** Cuts off ears in sequence, the one nearest to equal sides first (Meisters 1975, two ears theorem). All go
   * round in the sense of the polygon. Time grows with the square of the corners. */
  std::vector<CutTriangle> ears();
  /** Whether the ears may overlap or be flat: the polygon crosses itself, or has no area. */
  bool faulty() const { return faulty_; }

private:
  bool crossesItself() const;
  double shape(std::size_t before, std::size_t at, std::size_t after) const;
  bool empty(std::size_t before, std::size_t at, std::size_t after) const;
  double valueOf(std::size_t place) const;
  void cutOff(std::size_t place, std::vector<CutTriangle>& triangles);

  std::vector<Eigen::Vector2d> corners_; ///< as shares of the polygon's size
  std::vector<std::size_t> left_;        ///< corners not cut off, in order
  std::vector<double> values_;           ///< for each of them, the shape of its ear; below 0 if it is no ear
  bool faulty_ = false;
};

} // namespace pcl_spiral
