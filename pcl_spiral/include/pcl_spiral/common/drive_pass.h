// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Drive points in travel order.
 */
#pragma once

#include <pcl_spiral/common/impl/drive_point.h>

#include <vector>

namespace pcl_spiral {

/** Drive points in travel order. The tool follows them without leaving the surface. */
struct DrivePass {
  DrivePoints points;
  bool closed = false; ///< the last point joins the first, which is not repeated
};

using DrivePasses = std::vector<DrivePass>;

} // namespace pcl_spiral
