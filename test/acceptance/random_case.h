// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A random part, a scan of it and a random job.
 */
#pragma once

#include "support/surfaces.h"

#include <pcl_spiral/spiral/spiral_settings.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Geometry>

#include <cstdint>
#include <string>

namespace pcl_spiral::acceptance {

/** Lengths in mm. \p motion moves the exact surface to the scan. */
struct RandomCase {
  std::string name; ///< surface, outline, scan and job in words
  test::SurfacePtr surface;
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud;
  SpiralSettings settings;
  double spacing = 0.0; ///< of the same number of points spread evenly over the area
  double noise = 0.0;   ///< standard deviation along the normal
  double bend = 0.0;    ///< largest normal curvature, 1/mm
  double concave = 0.0; ///< largest concave curvature, 1/mm
  std::size_t outliers = 0;
  bool even = true; ///< spread evenly over the area; otherwise in scan lines
};

/** Case \p index of the series \p seed; the same on every platform. */
RandomCase randomCase(std::uint64_t seed, std::uint64_t index);

/** The job of \p random by \p method: at constant scallop height without centre, lines and pitch, which it does not use. */
SpiralSettings settingsOf(const RandomCase& random, SpiralMethod method);

} // namespace pcl_spiral::acceptance
