// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The stock over a part of a page, and when it falls. Private to io. Lengths in mm.
 */
#pragma once

#include "scene_part.h"

#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/core/cutter_profile.h>
#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/planning/impl/path_judging.h>

#include <vector>

namespace pcl_spiral {

/** The stock at each place of \p part: that of the nearest sample of the mesh. */
void takeStock(const Heights& judged, ScenePart& part);

/** When the stock falls over each place whose stock was judged: first, and to what is left. \p reached: when the tool is at each point of
 *  \p path, s. \p judged: limit and reach. Where it cannot be found, all falls at ScenePart::cut_at. */
void findFalls(const pcl::PointCloud<ToolpathPoint>::ConstPtr& path, const Polyline& tips, const CutterShape& cutter,
               const RemovalReport& judged, const std::vector<double>& reached, ScenePart& part);

} // namespace pcl_spiral
