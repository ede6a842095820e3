// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Section planes of a scan as close as the scallop asks. Private.
 */
#pragma once

#include "core/row_levels.h"
#include <pcl_spiral/drive/drive_settings.h>
#include <pcl_spiral/surface/surface.h>

namespace pcl_spiral {

/** Planes between \p low and \p high, mm along \p across from \p origin. With a fixed tool axis the ball's
 * centres are in the planes; otherwise, dropped along the surface's normal, its contacts. Of a cloud denser
 * than half a step one place a cell of that size is looked at. Steps are held at a quarter of that on a
 * plane, with a warning. */
RowLevels keptRows(const Surface& surface, const DriveSettings& settings, const Eigen::Vector3d& across, const Eigen::Vector3d& origin,
                   double low, double high, DriveReport& report);

} // namespace pcl_spiral
