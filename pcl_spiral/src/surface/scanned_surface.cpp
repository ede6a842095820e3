// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/surface/scanned_surface.h>

namespace pcl_spiral {

template class ScannedSurface<pcl::PointXYZ>;
template class ScannedSurface<pcl::PointXYZRGB>;
template class ScannedSurface<pcl::PointXYZI>;
template class ScannedSurface<pcl::PointNormal>;

} // namespace pcl_spiral
