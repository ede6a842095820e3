// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Section planes of a scan as close as the scallop height needs. Private.
 */
#pragma once

#include "core/row_levels.h"
#include <pcl_spiral/drive/drive_settings.h>
#include <pcl_spiral/surface/surface.h>

namespace pcl_spiral {

/** Planes between \p low and \p high, mm along \p across from \p origin. With a fixed tool axis the tips of the
 *  cutter are in the planes; otherwise the cutter drops along the surface normal, and its contacts are in the
 *  planes. If a cloud is denser than half the step of the cutter's corner on a plane, one point in each cell of that
 *  size is used. Steps are at least a quarter of that step, with a warning. */
RowLevels keptRows(const Surface& surface, const DriveSettings& settings, const Eigen::Vector3d& across, const Eigen::Vector3d& origin,
                   double low, double high, DriveReport& report);

} // namespace pcl_spiral
