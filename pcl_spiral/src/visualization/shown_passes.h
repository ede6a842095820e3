// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Chooses the passes of a path that a picture can show separately.
 */
#pragma once

#include "depth_map.h"

#include <pcl_spiral/common/point_types.h>

#include <pcl/point_cloud.h>

#include <string>
#include <vector>

namespace pcl_spiral {

/** The shown passes, by the whole number in the turn of their points. */
struct ShownPasses {
  std::vector<bool> shown;
  std::size_t seen = 0; ///< passes that the part does not hide completely

  bool shows(double turn) const;
  /** "every pass shown", "31 of 120 passes shown"; \p turn: "turn" or "pass". */
  std::string caption(const std::string& turn) const;
};

/** Chooses, in the order of the path, each pass of which two fifths of the visible part are \p least pixels from the passes chosen
 *  before. Passes may be in any order, beside several others, and end anywhere. */
ShownPasses choosePasses(const pcl::PointCloud<ToolpathPoint>& path, const Canvas& canvas, const DepthMap& depth, double least);

} // namespace pcl_spiral
