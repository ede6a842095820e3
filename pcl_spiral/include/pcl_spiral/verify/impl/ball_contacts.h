// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Where a ball is nearest to the surface of a scan.
 */
#pragma once

#include <pcl_spiral/verify/impl/reference_surface.h>

#include <Eigen/Core>

#include <vector>

namespace pcl_spiral {

/** The place of a ball that is nearest to a surface, mm. */
struct BallContact {
  Eigen::Vector3d position = Eigen::Vector3d::Zero(); ///< on the ball
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit, out of the material
  double height = 0.0;                                ///< of the ball above the surface; negative: in the material
  bool valid = false;                                 ///< false: there is no surface near the ball
};

/** The contacts of balls of \p radius about \p centres, in their order. From the scan point nearest to a centre, the foot is followed
 *  along the fitted quadrics to the place of the surface that is nearest to the centre. Parallel, the same for any number of threads. */
std::vector<BallContact> ballContacts(const ReferenceSurface& reference, const std::vector<Eigen::Vector3d>& centres, double radius);

} // namespace pcl_spiral
