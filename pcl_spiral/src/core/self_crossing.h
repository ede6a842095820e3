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

/** Index of the first segment of \p path that crosses another one as seen along the normal of its first point.
 *  Segments that share a point do not count, nor crossings whose ends all stay within \p slack of the other segment.
 *  Segments may pass above each other: a crossing is found if they do so within 0.15 of the mean segment plus four
 *  times the slack, and never beyond three mean segments (or a fifth of the longest, if that is more).
 *  \p normals unit, one per point. \p passes: points before which the tool was lifted; the move to each is no segment. Time is nearly
 *  linear in the number of points for segments of similar length, much longer if turns lie much closer together than segments are long.
 *  \p go_on is called now and then with the share done; if it returns false, the search ends without a crossing. */
std::optional<std::size_t> firstSelfCrossing(const Polyline& path, const std::vector<Eigen::Vector3d>& normals, double slack = 0.0,
                                             const std::function<bool(double)>& go_on = {}, const std::vector<std::size_t>& passes = {});

} // namespace pcl_spiral
