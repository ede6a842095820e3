// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/ridge/ridge_toolpath.h>

namespace pcl_spiral {

template class RidgeToolpath<pcl::PointXYZ>;
template class RidgeToolpath<pcl::PointXYZRGB>;
template class RidgeToolpath<pcl::PointNormal>;

} // namespace pcl_spiral
