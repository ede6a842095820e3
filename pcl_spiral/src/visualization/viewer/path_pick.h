// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Which point of the path the user points at.
 */
#pragma once

#include "visualization/part_view.h"

#include <cstddef>
#include <functional>
#include <optional>

namespace pcl_spiral {

/** The path's point that is seen nearest to \p pixel, of those for which \p shown is true; none within 12
 * pixels: nothing. */
std::optional<std::size_t> pickPoint(const PartView& view, const pcl::PointCloud<ToolpathPoint>& path,
                                     const std::function<bool(const ToolpathPoint&)>& shown, const Eigen::Vector2d& pixel);

} // namespace pcl_spiral
