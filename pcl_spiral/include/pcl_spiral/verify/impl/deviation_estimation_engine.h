// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Distance of the contacts of a path from the surface by which they are judged.
 */
#pragma once

#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/verify/figures.h>
#include <pcl_spiral/verify/impl/cutter_path.h>
#include <pcl_spiral/verify/impl/reference_surface.h>
#include <pcl_spiral/verify/impl/turn_wobble.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl_spiral {

/** Signed deviation of each path point, NaN where it is not measured, and the figures. \p chord_error is compared
 *  with the noise; 0: no comparison. Fails if no point lies on the scan, and when \p progress cancels. */
Status measureDeviation(const ReferenceSurface& reference, const CutterPath& path, double chord_error, const ProgressCallback& progress,
                        std::vector<float>& deviation, DeviationReport& figures);

} // namespace pcl_spiral
