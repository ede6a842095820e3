// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Finds the point of the path under the mouse.
 */
#pragma once

#include "visualization/part_view.h"

#include <cstddef>
#include <functional>
#include <optional>

namespace pcl_spiral {

/** The visible path point nearest to \p pixel, of those for which \p shown is true; nothing if none is within 12
 * pixels. */
std::optional<std::size_t> pickPoint(const PartView& view, const pcl::PointCloud<ToolpathPoint>& path,
                                     const std::function<bool(const ToolpathPoint&)>& shown, const Eigen::Vector2d& pixel);

} // namespace pcl_spiral
