// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Ends of a column, in sectors round its axis.
 */
#pragma once

#include <pcl_spiral/drive/impl/drive_cylinder.h>
#include <pcl_spiral/planning/impl/drive_planning.h>

#include <vector>

namespace pcl_spiral {

/** Where the given points begin and end along a column, in sectors round it. */
class ColumnEnds {
public:
  explicit ColumnEnds(const DriveCylinder& cylinder);

  void add(const Eigen::Vector3d& place);
  /** Largest length, mm, at an end of a sector that \p inner does not reach; a few outliers do not count. */
  double missedBy(ColumnEnds& inner);

private:
  DriveCylinder cylinder_;
  Eigen::Vector3d e1_, e2_;
  std::vector<std::vector<double>> along_; ///< of each sector
};

/** Warns of the parts of a column's ends that no contact reaches. */
void warnOfEnds(const DrivePlanInput& input, const std::vector<ToolLocations>& located, PassPlan& plan);

} // namespace pcl_spiral
