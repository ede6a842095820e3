// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Warning for a length below the noise of a scan.
 */
#pragma once

#include <pcl_spiral/surface/impl/mls_surface.h>

#include <optional>
#include <string>

namespace pcl_spiral {

/** A warning if \p asked, mm, is below the standard deviation of a point. \p what is its name. */
std::optional<std::string> noiseWarning(const MlsSurface& surface, const char* what, double asked);

} // namespace pcl_spiral
