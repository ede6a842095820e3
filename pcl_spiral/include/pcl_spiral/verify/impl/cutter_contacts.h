// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Where a cutter is nearest to the surface of a scan.
 */
#pragma once

#include <pcl_spiral/core/impl/swept_error.h>
#include <pcl_spiral/verify/impl/reference_surface.h>

#include <Eigen/Core>

#include <vector>

namespace pcl_spiral {

/** The place of a cutter that is nearest to a surface, mm. */
struct NearestContact {
  Eigen::Vector3d position = Eigen::Vector3d::Zero(); ///< on the cutter
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit, out of the material
  double height = 0.0;                                ///< of the cutter above the surface; negative: in the material
  bool valid = false;                                 ///< false: there is no surface near the cutter
};

/** The contacts of balls of \p radius about \p centres, in their order. From the scan point nearest to a centre, the foot is followed
 *  along the fitted quadrics to the place of the surface that is nearest to the centre. Parallel, the same for any number of threads. */
std::vector<NearestContact> ballContacts(const ReferenceSurface& reference, const std::vector<Eigen::Vector3d>& centres, double radius);

/** The contacts of a cutter of any profile at \p places, in their order. From the scan point that is deepest in the cutter, or nearest to
 *  it, the deepest place is looked for on the fitted quadrics; for balls as ballContacts does. Where the cutter is flat, one of many
 *  places is taken. Parallel, the same for any number of threads. */
std::vector<NearestContact> cutterContacts(const ReferenceSurface& reference, const std::vector<CutterPlace>& places,
                                           const CutterShape& cutter);

} // namespace pcl_spiral
