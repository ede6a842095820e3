// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The clouds for all times. Lengths in mm.
 */
#pragma once

#include "support/surfaces.h"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl_spiral::benchmarks {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Points = std::vector<Eigen::Vector3f>;

/** How a cloud is sampled from a surface. */
struct CloudPlan {
  test::SurfacePtr surface;
  std::size_t points = 0;
  double noise = 0.0;        ///< standard deviation along the normal
  double false_echoes = 0.0; ///< share of points moved 5 to 20 mm in front of or behind the surface
};

/** The half spheroid of the published part: 3300 across, 860 high. */
test::SurfacePtr domeSurface();

/** The same points for the same plan on every computer, in random order. */
Points sampledPoints(const CloudPlan& plan);

/** Ordered so that neighbours are close to each other in memory. */
Points inSpatialOrder(const Points& points);

Cloud::Ptr toCloud(const Points& points);

/** Names of sizes: "86k", "2M". */
std::string sizeName(std::size_t points);

} // namespace pcl_spiral::benchmarks
