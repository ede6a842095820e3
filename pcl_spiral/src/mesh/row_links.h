// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Rows joined on the surface, so that the tool is not lifted between them.
 */
#pragma once

#include <pcl_spiral/common/drive_pass.h>
#include <pcl_spiral/core/polyline.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace pcl_spiral {

/** The drive points on the surface next to the places, in their order; none if there is no surface,
 * beyond its rim or over a gap. Called with the places of all links together, so that they can be checked
 * in parallel. */
using PlacesOnSurface = std::function<std::vector<std::optional<DrivePoint>>(const Polyline& places)>;

/** The same for one place. */
using PlaceOnSurface = std::function<std::optional<DrivePoint>(const Eigen::Vector3d& place)>;

/** What a link may be. Lengths in mm. */
struct LinkLimits {
  double longest = 0.0; ///< straight, and on the surface
  double look = 0.0;    ///< largest distance of places that are checked
  double spacing = 0.0; ///< largest distance of drive points
};

/** What came of it. */
struct RowLinks {
  std::size_t made = 0;
  std::size_t not_made = 0; ///< passes, except the first, that stay passes of their own
};

/** Join each open pass to the one before if it begins no farther from the end of that one than the longest
 * link, and if the straight way between is all over the surface. Links run on the surface. Order and
 * directions are kept; closed passes stay alone. */
RowLinks linkRows(DrivePasses& passes, const LinkLimits& limits, const PlacesOnSurface& on_surface);

/** The same, with places checked one by one. */
RowLinks linkRows(DrivePasses& passes, const LinkLimits& limits, const PlaceOnSurface& on_surface);

} // namespace pcl_spiral
