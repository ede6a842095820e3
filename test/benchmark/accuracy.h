// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A fast check of a path against the exact surface, printed with every time. mm.
 */
#pragma once

#include "run_case.h"

#include <pcl_spiral/common/point_types.h>

namespace pcl_spiral::benchmarks {

struct Accuracy {
  double deviation_max = 0.0, deviation_rms = 0.0; ///< of the contacts from the surface
  double longest_move = 0.0;
  double length_ratio = 0.0; ///< of the path to the least length; 0 if that is not known
};

Accuracy accuracyOf(const RunCase& run, const pcl::PointCloud<ToolpathPoint>& path);

} // namespace pcl_spiral::benchmarks
