// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A loop of a path at constant scallop height, and the figures of such a path.
 */
#pragma once

#include <pcl_spiral/core/impl/step_over_metric.h>
#include <pcl_spiral/core/polyline.h>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** Tool radius and scallop height that a field, a loop or a path was made with, mm; 0: not known, as of the user's own. A stage that gets
 *  it refuses to use others. */
struct StepOverBasis {
  double tool_radius = 0.0;    ///< of the ball
  double scallop_height = 0.0; ///< allowed
};

/** A loop at a whole number of step-overs from the boundaries. Parallel arrays. Places along it are arc lengths in step-overs,
 *  which wrap round. */
struct ScallopLoop {
  Polyline points;                    ///< mm; the first is not repeated; larger distances from the boundaries on their left
  std::vector<StepOverMetric> metric; ///< one per point
  std::vector<double> arcs;           ///< step-overs; one more than points: the last is the whole length
  int level = 0;                      ///< step-overs from the boundaries; 0: a boundary
  StepOverBasis basis;                ///< what its step-overs are made with

  double length() const { return arcs.empty() ? 0.0 : arcs.back(); } ///< Whole length, step-overs.
  /** \p u wrapped into 0 to the length. */
  double wrapped(double u) const;
  Eigen::Vector3d at(double u) const;      ///< The place at \p u, mm.
  StepOverMetric metricAt(double u) const; ///< The metric at \p u.
  /** Measure the arc lengths from points and metric. */
  void measure();
};

/** Parts and figures of a path at constant scallop height. Lengths in mm. */
struct ScallopReport {
  std::size_t loops = 0;           ///< from the boundaries inward
  std::size_t chain_loops = 0;     ///< in the spiral from the rim to the innermost loop
  std::size_t bridges = 0;         ///< loops beside it, each joined to a neighbour by two narrow turns
  std::size_t dots = 0;            ///< small loops that became a finger of a neighbour
  std::vector<Polyline> lines;     ///< the loops, closed, simplified for pictures
  std::vector<Polyline> axes;      ///< of the fingers
  std::size_t fingers = 0;         ///< places where loops reach out so that no higher ridge is left
  double reversed_share = 0.0;     ///< of the path, travelled against the requested sense, as loops beside the chain must be
  std::size_t lifts = 0;           ///< from one pass to the next, if the requested sense is kept everywhere
  double lift_length = 0.0;        ///< of the straight moves between passes, which path lengths do not count
  double least_length = 0.0;       ///< integral of dA / largest step-over, plus half the boundary length: least of any path at this scallop
  double smallest_step_over = 0.0; ///< mm: the smallest that the height allows along the path
  double largest_step_over = 0.0;  ///< mm: the largest
  double start_off = 0.0;          ///< mm: distance of the path's end on the rim from the requested start point
  double rim_length = 0.0;         ///< mm
  double turn_radius = 0.0;        ///< step-overs: all but 0.1 % of the path have a larger radius
  double least_radius = 0.0;       ///< step-overs: of the sharpest turn
  Eigen::Vector3d sharpest_place = Eigen::Vector3d::Zero(); ///< its place
  double farthest = 0.0; ///< largest distance of a place of the surface from the path, in step-overs; 0.5 leaves the requested height
  Eigen::Vector3d farthest_place = Eigen::Vector3d::Zero(); ///< that place
};

/** \deprecated Use ScallopReport. */
using ScallopFigures [[deprecated("use ScallopReport")]] = ScallopReport;

} // namespace pcl_spiral
