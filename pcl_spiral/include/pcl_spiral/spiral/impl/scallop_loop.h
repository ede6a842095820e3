// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A closed line on a surface with lengths in step-overs.
 */
#pragma once

#include <pcl_spiral/core/impl/polyline.h>
#include <pcl_spiral/core/impl/step_over_metric.h>

#include <vector>

namespace pcl_spiral {

/** A loop at a whole number of step-overs from the boundaries. Parallel arrays. Places along it are arc lengths in step-overs,
 *  which wrap round. */
struct ScallopLoop {
  Polyline points;                    ///< mm; the first is not repeated; larger distances from the boundaries on their left
  std::vector<StepOverMetric> metric; ///< one per point
  std::vector<double> arcs;           ///< step-overs; one more than points: the last is the whole length
  int level = 0;                      ///< step-overs from the boundaries; 0: a boundary

  double length() const { return arcs.empty() ? 0.0 : arcs.back(); }
  /** \p u wrapped into 0 to the length. */
  double wrapped(double u) const;
  Eigen::Vector3d at(double u) const;
  StepOverMetric metricAt(double u) const;
  /** Measure the arc lengths from points and metric. */
  void measure();
};

} // namespace pcl_spiral
