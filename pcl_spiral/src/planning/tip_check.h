// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Checks the tool tips of a path against its contacts.
 */
#pragma once

#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/core/cutter_profile.h>
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/verify/verification.h>

#include <pcl/point_cloud.h>

namespace pcl_spiral {

/** Counts \p tips, one for each point of \p path or none, that are not where \p cutter has them: of a ball those that differ from the tip
 *  at their contact, of another cutter those that do not bring its side there. \return a warning, empty if all are right */
Diagnostic checkTips(const pcl::PointCloud<ToolpathPoint>& path, const Polyline& tips, const CutterShape& cutter,
                     Verification& verification);

} // namespace pcl_spiral
