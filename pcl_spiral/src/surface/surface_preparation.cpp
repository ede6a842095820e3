// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/surface/surface_preparation.h>

namespace pcl_spiral {

template class SurfacePreparation<pcl::PointXYZ>;
template class SurfacePreparation<pcl::PointXYZRGB>;
template class SurfacePreparation<pcl::PointXYZI>;
template class SurfacePreparation<pcl::PointNormal>;

} // namespace pcl_spiral
