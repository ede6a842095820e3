// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/verify/deviation_estimation.h>

namespace pcl_spiral {

template class DeviationEstimation<pcl::PointXYZ>;
template class DeviationEstimation<pcl::PointXYZRGB>;
template class DeviationEstimation<pcl::PointNormal>;

} // namespace pcl_spiral
