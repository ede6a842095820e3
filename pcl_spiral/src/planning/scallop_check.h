// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Whether passes leave no more than the scallop height asked for.
 */
#pragma once

#include <pcl_spiral/planning/impl/drive_planning.h>

namespace pcl_spiral {

/** Of the scallop height asked for: what passes may leave, for the errors of its measure. */
constexpr double more_left = 1.1;

/** Moves the cutter along its passes and measures what it leaves over the surface of the scan, or over the mesh. Fails where passes leave
 *  more than scallop height and tolerance on more than a fiftieth of it, with the height, the place and the share, and warns where they do
 *  on less. Warns, also without a scallop height, where rows of a fixed axis do not reach more than a fiftieth of a scan. */
Status checkScallop(const DrivePlanInput& input, PassPlan& plan);

} // namespace pcl_spiral
