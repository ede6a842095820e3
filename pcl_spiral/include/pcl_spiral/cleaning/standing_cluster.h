// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Things on a scanned surface.
 */
#pragma once

#include <pcl/types.h>

#include <Eigen/Core>

#include <vector>

namespace pcl_spiral {

/** Points near each other that stand off the surface: a screw, a clamp, spatter. Lengths in mm. */
struct StandingCluster {
  pcl::Indices indices;                            ///< of its points in the cloud
  std::vector<Eigen::Vector3f> positions;          ///< of its points, mm
  Eigen::Vector3d place = Eigen::Vector3d::Zero(); ///< its mean
  double size = 0.0;                               ///< diagonal of its box
  double spacing = 0.0;                            ///< of its points: median of the mean distance of the nearest three
  double height = 0.0;                             ///< of its highest point over the surface
  bool hides_surface = false;                      ///< nothing is seen below some of its points: where its sides are, is not known
};

} // namespace pcl_spiral
