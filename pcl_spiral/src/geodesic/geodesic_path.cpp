// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/geodesic/geodesic_path.h>

namespace pcl_spiral {

template class GeodesicPath<pcl::PointXYZ>;
template class GeodesicPath<pcl::PointXYZRGB>;
template class GeodesicPath<pcl::PointNormal>;

} // namespace pcl_spiral
