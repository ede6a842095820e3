// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Checks settings, and whether the scan fits them.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/spiral/scallop_loop.h>
#include <pcl_spiral/spiral/spiral_settings.h>
#include <pcl_spiral/surface/surface.h>

namespace pcl_spiral {

/** Ok, or an error with the invalid setting, its value and the remedy. */
Status checkSettings(const SpiralSettings& settings);

/** Ok, or an error with both values if \p made and \p used are known and differ. \p what: the name of what was made. */
Status checkBasis(const StepOverBasis& made, const StepOverBasis& used, const Diagnostic& what);

/** Ok, or an error if the path would be too large. Adds scanWarnings, and one of a scan smaller than the cutter, to \p warnings. */
Status checkScale(const Surface& surface, const SpiralSettings& settings, Diagnostics& warnings);

} // namespace pcl_spiral
