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
  /** The Voronoi cell: corners counter-clockwise, and with each the neighbour whose bisector the edge from it to the next
   *  lies on, -1 on the first square. Filled up with the point itself, which no bisector cuts off, to whole lanes. */
  struct Cell {
    std::vector<double> x, y;
    std::vector<int> edge;
    int size = 0;

    void resize(int room);
    void add(double corner_x, double corner_y, int next_edge);
    void fillUp();
  };
  /** Cut off what is nearer to (u, v) than to the point; returns whether anything was. */
  bool clip(double u, double v, int neighbour);

  Cell cell_, clipped_;
  std::vector<double> side_;
  std::vector<Spoke> spokes_;
  double reach_ = 0.0;
};

} // namespace pcl_spiral
