// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A picture of the largest ball that reaches each place of a surface, made without a window.
 */
#pragma once

#include <pcl_spiral/visualization/pictures.h>

#include <string>
#include <vector>

namespace pcl_spiral {

/** Contents of the picture; lengths in mm. */
struct ReachScene {
  PictureScene part;        ///< its cloud are the points of the map; of its report only the loops are used
  std::vector<float> radii; ///< of the largest ball, for each point of the cloud
  double largest = 0.0;     ///< radius up to which balls were tried
};

/** The points coloured by the largest ball, the tightest in front. The tightest place is marked, and enlarged at the side with the path.
 *  The title counts the points that the ball of the path does not reach. A PNG of 1600 x 1200; the same scene gives the same bytes.
 *  \throw std::invalid_argument without points or a path, or if the radii are not one per point; std::runtime_error without a display;
 *  FileError if the file cannot be written */
void writeReach(const std::string& file, const ReachScene& scene);

} // namespace pcl_spiral
