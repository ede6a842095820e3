/** \file
 *  The Delaunay neighbours of one point in its tangent plane.
 */
#pragma once

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Neighbours of a point in counter-clockwise order, found by clipping its Voronoi cell with one bisector after the
 *  other, nearest first. A triangle stands between a neighbour and the next one when the Voronoi vertex between them,
 *  its circumcentre, is no farther than the largest allowed circumradius.
 */
class LocalStar {
public:
  struct Spoke {
    int neighbour;      ///< position in the arrays given to compute
    bool triangle_next; ///< whether a triangle stands between this spoke and the next
  };

  /** \p u, \p v: offsets of \p count neighbours from the point in its tangent plane, nearest in space first; the
   *  first is the point itself. \p max_circumradius in the same unit. */
  void compute(const double* u, const double* v, int count, double max_circumradius);

  const std::vector<Spoke>& spokes() const { return spokes_; }
  /** Distance of the farthest vertex of the cell, before triangles were dropped, but at most twice
   *  the largest circumradius: neighbours beyond twice this distance cannot change the star. */
  double reach() const { return reach_; }

private:
  /** A corner of the cell, and the neighbour whose bisector the edge from it to the next lies on; -1 the first square. */
  struct Vertex {
    double x, y;
    int edge;
  };
  /** Cut off what is nearer to (u, v) than to the point; returns whether anything was. */
  bool clip(double u, double v, int neighbour);

  std::vector<Vertex> cell_, clipped_; ///< the first size_ are in use
  std::vector<double> side_;
  std::size_t size_ = 0;
  std::vector<Spoke> spokes_;
  double reach_ = 0.0;
};

} // namespace pcl_spiral
