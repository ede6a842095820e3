/** \file
 *  How large a spiral would become, foretold before it is made.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/graph/impl/surface_graph.h>
#include <pcl_spiral/spiral/spiral_settings.h>

namespace pcl_spiral {

/** Points that a path may have: some 200 times the path of a tank dome of 3.3 m with turns 2 mm apart. */
constexpr double most_path_points = 1e8;

/** What a spiral asks for. */
struct PathSize {
  double points = 0.0; ///< of the path
  double knots = 0.0;  ///< turns times radial lines; 0 as long as the lines are not known
  double turns = 0.0;
  double step_over = 0.0, step = 0.0; ///< mean distances of turns, and of points along them, mm

  /** Memory at the peak, estimated: as much a point of the path, and a knot. */
  double bytes() const { return 200.0 * points + 150.0 * knots; }
};

/** Area of the surface, mm2: of each point's share of it. */
double
surfaceArea(const SurfaceGraph& graph);

/** From the \p area alone: turns a flat step-over apart, of the longest moves. A hollow takes fewer points, whatever bends
 *  the path takes more. */
PathSize
roughPathSize(double area, const SpiralSettings& settings);

/** Ok, or refused with the estimate: more than \p most points, or more memory than there is. */
Status
checkPathSize(const PathSize& size, double area, const SpiralSettings& settings, double most = most_path_points);

} // namespace pcl_spiral
