// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A length asked for that a scan is too noisy to show.
 */
#pragma once

#include <pcl_spiral/surface/impl/mls_surface.h>

#include <optional>
#include <string>

namespace pcl_spiral {

/** A warning when \p asked, mm, lies below the standard deviation of a point; \p what it is the name of. */
std::optional<std::string> noiseWarning(const MlsSurface& surface, const char* what, double asked);

} // namespace pcl_spiral
