// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Ends of a column, in sectors round its axis.
 */
#pragma once

#include "planning.h"

#include <pcl_spiral/cutter/tool_location.h>
#include <pcl_spiral/drive/impl/drive_cylinder.h>

#include <vector>

/** Where the given points begin and end along a column, in sectors round it. */
class ColumnEnds {
public:
  explicit ColumnEnds(const pcl_spiral::DriveCylinder& cylinder);

  void add(const Eigen::Vector3d& place);
  /** Largest length, mm, at an end of a sector that \p inner does not reach; a few outliers do not count. */
  double missedBy(ColumnEnds& inner);

private:
  pcl_spiral::DriveCylinder cylinder_;
  Eigen::Vector3d e1_, e2_;
  std::vector<std::vector<double>> along_; ///< of each sector
};

/** Warns of the parts of a column's ends that no contact reaches. */
void warnOfEnds(const Job& job, const std::vector<pcl_spiral::ToolLocations>& located, Result& result);
