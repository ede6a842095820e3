// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The refusal of points that are no single sheet, with how they lie. Private.
 */
#pragma once

#include <pcl_spiral/common/status.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** A point and its height over the surface fitted about it, mm. */
struct PointHeight {
  Eigen::Vector3d place;
  double value; ///< above 0 on the outer side
};

/** Refuses points of this \p noise and \p spacing about a local surface, mm. \p heights: of some hundreds of them. */
Status sheetRefusal(double noise, double spacing, const std::vector<PointHeight>& heights);

} // namespace pcl_spiral
