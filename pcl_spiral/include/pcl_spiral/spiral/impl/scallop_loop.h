/** \file
 *  A closed line on a surface with lengths in step-overs.
 */
#pragma once

#include <pcl_spiral/core/impl/polyline.h>
#include <pcl_spiral/core/impl/step_over_metric.h>

#include <vector>

namespace pcl_spiral {

/** A loop at a whole number of step-overs from the rims. Parallel arrays; places along it are arc lengths in step-overs, which
 *  wrap round. */
struct ScallopLoop {
  Polyline points;                    ///< mm; the first is not repeated; larger distances from the rims on their left
  std::vector<StepOverMetric> metric; ///< one a point
  std::vector<double> arcs;           ///< step-overs; one more than points: the whole length at the end
  int level = 0;                      ///< step-overs from the rims; 0: a rim

  double length() const { return arcs.empty() ? 0.0 : arcs.back(); }
  /** \p u brought between 0 and the length. */
  double wrapped(double u) const;
  Eigen::Vector3d at(double u) const;
  StepOverMetric metricAt(double u) const;
  /** Arc lengths of points and metric. */
  void measure();
};

} // namespace pcl_spiral
