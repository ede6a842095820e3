// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Which passes of a path a picture can show apart.
 */
#pragma once

#include "depth_map.h"

#include <pcl_spiral/common/point_types.h>

#include <pcl/point_cloud.h>

#include <string>
#include <vector>

namespace pcl_spiral {

/** The passes shown, by the whole number that their points have as turn. */
struct ShownPasses {
  std::vector<bool> shown;
  std::size_t seen = 0; ///< passes of which the part does not hide everything

  bool shows(double turn) const;
  /** "every pass shown", "31 of 120 passes shown"; \p turn: "turn" or "pass". */
  std::string caption(const std::string& turn) const;
};

/** In the path's order each pass of which two fifths of what is seen keep \p least pixels from those chosen before. Passes may
 *  follow one another in any order, lie beside several others, and end anywhere. */
ShownPasses choosePasses(const pcl::PointCloud<ToolpathPoint>& path, const Canvas& canvas, const DepthMap& depth, double least);

} // namespace pcl_spiral
