// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/features/centroid_boundary_estimation.h>

namespace pcl_spiral {

template class CentroidBoundaryEstimation<pcl::PointXYZ, pcl::Normal>;
template class CentroidBoundaryEstimation<pcl::PointXYZRGB, pcl::Normal>;
template class CentroidBoundaryEstimation<pcl::PointNormal, pcl::Normal>;
template class CentroidBoundaryEstimation<pcl::PointNormal, pcl::PointNormal>;

} // namespace pcl_spiral
