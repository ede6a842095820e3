// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A simulated scan of the ridge of a press die, and its two measured lines.
 */
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

/** Settings of the scan of the ridge; lengths in mm. */
struct RidgeScanSettings {
  double line_spacing = 0.5;  ///< of scan lines across the ridge, along its rail
  double point_spacing = 0.5; ///< of the points on a line
  double noise = 0.02;        ///< standard deviation of each coordinate
  double outliers = 0.0005;   ///< share of outliers, 5 to 20 mm off the surface
  unsigned seed = 1;
};

/** The full scan, 300 points of the rail and 60 of the generator, all with the same noise. */
struct RidgeScan {
  pcl::PointCloud<pcl::PointXYZ> scan, rail, generator;
};

/** The rail (600 t, 60 sin 1.6 pi t, 40 sin pi t) carries the generator b = 24 w, c = 20 w (1 - w) (1 + (1 - 2 w) / 2), whose chord keeps
 *  -15 degrees with the horizontal plane; the generator is measured at t = 0.37. */
RidgeScan simulateRidge(const RidgeScanSettings& settings);

/** An outlier is 5 to 20 mm in front of or behind the surface; \p share is uniform in 0 to 1. */
double outlierDistance(double share);
