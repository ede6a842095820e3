// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The prism of a user's polygon.
 */
#pragma once

#include <pcl_spiral/core/prism.h>

#include <vector>

namespace pcl_spiral {

/** Over the polygon through \p corners: along its mean normal if they \p have_heights, else along z. */
inline Prism
prismOver(const std::vector<Eigen::Vector3d>& corners, bool have_heights)
{
  const Eigen::Vector3d area = have_heights ? polygonArea(corners) : Eigen::Vector3d(Eigen::Vector3d::UnitZ());
  return {corners, area.norm() > 0.0 ? area : Eigen::Vector3d(Eigen::Vector3d::UnitZ())};
}

} // namespace pcl_spiral
