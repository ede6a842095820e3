// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Where a path on a surface crosses itself.
 */
#pragma once

#include <pcl_spiral/core/polyline.h>

#include <functional>
#include <optional>
#include <vector>

namespace pcl_spiral {

/** Index of the first segment of \p path that crosses another one as seen along the normal of its first point;
 *  segments that share a point do not count, nor crossings whose ends all stay within \p slack of the other segment.
 *  Segments may pass over each other: a crossing is found where they do so within 0.15 of the mean segment and four
 *  times the slack, and never beyond three mean segments (or a fifth of the longest, if that is more).
 *  \p normals unit, one a point. \p passes: points where the tool was lifted before; the move to each is no segment. Near-linear in the
 *  number of points for segments of like length; where turns lie much closer together than segments are long, far slower: \p go_on, called
 *  now and then with the share done, ends the search without a crossing by returning false. */
std::optional<std::size_t> firstSelfCrossing(const Polyline& path, const std::vector<Eigen::Vector3d>& normals, double slack = 0.0,
                                             const std::function<bool(double)>& go_on = {}, const std::vector<std::size_t>& passes = {});

} // namespace pcl_spiral
