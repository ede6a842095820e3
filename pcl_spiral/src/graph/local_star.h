// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The Delaunay neighbours of one point in its tangent plane.
 */
#pragma once

#include <vector>

namespace pcl_spiral {

/** Neighbours of a point in counter-clockwise order, found by walking round its Voronoi cell: along the
 * bisector of one neighbour up to the first bisector that cuts it, then along that one, from the nearest neighbour
 * back to it. There is a triangle between a neighbour and the next one if the Voronoi vertex between them,
 * its circumcentre, is no farther than the largest allowed circumradius. Of several neighbours on one circle with the
 * point, those that only touch a corner are left out.
 */
class LocalStar {
public:
  struct Spoke {
    int neighbour;      ///< position in the arrays given to compute
    bool triangle_next; ///< whether there is a triangle between this spoke and the next
  };

  /** \p u, \p v: offsets of \p count neighbours from the point in its tangent plane, nearest in space first;
   * the first is the point itself. \p max_circumradius in the same unit. */
  void compute(const double* u, const double* v, int count, double max_circumradius);

  const std::vector<Spoke>& spokes() const { return spokes_; }
  /** Distance of the farthest vertex of the cell, before triangles were dropped, but at most twice
   *  the largest circumradius: neighbours beyond twice this distance cannot change the star. */
  double reach() const { return reach_; }

private:
  struct Corner {
    double u, v;
  };
  /** Take the sides of a square, none of whose corners is within reach, and the neighbours. */
  void setSites(const double* u, const double* v, int count, double half_width);
  /** The cell of the first sites. */
  void walk(int sites, double max_circumradius);
  /** Whether any site from \p first to \p end cuts off a corner. */
  bool cutsCorner(int first, int end) const;

  std::vector<double> u_, v_, half_square_; ///< of each site; its bisector is u x + v y = half_square
  std::vector<double> cut_, ends_;
  std::vector<int> edges_;
  std::vector<Corner> corners_;
  std::vector<Spoke> spokes_;
  double reach_ = 0.0;
};

} // namespace pcl_spiral
