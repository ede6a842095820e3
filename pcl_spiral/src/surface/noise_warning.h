// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Warning for a length below the noise of a scan.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/fit/impl/mls_surface.h>

#include <optional>

namespace pcl_spiral {

/** A warning if \p asked, mm, is below the standard deviation of a point. \p what is its name. */
std::optional<Diagnostic> noiseWarning(const MlsSurface& surface, const char* what, double asked);

} // namespace pcl_spiral
