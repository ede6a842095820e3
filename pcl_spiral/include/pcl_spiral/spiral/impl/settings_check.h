/** \file
 *  Settings that cannot be, and scans that do not fit them.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/surface/surface.h>
#include <pcl_spiral/spiral/spiral_settings.h>

#include <string>
#include <vector>

namespace pcl_spiral {

/** Ok, or the setting that cannot be, with its value and remedy. */
Status
checkSettings(const SpiralSettings& settings);

/** Ok, or the scan is smaller than the cutter, or asks for a path too large to be made. Adds scanWarnings to \p warnings. */
Status
checkScale(const Surface& surface, const SpiralSettings& settings, std::vector<std::string>& warnings);

} // namespace pcl_spiral
