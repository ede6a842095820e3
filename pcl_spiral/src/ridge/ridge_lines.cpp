// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/ridge/ridge_lines.h>

namespace pcl_spiral {

template class RidgeLines<pcl::PointXYZ>;
template class RidgeLines<pcl::PointXYZRGB>;
template class RidgeLines<pcl::PointNormal>;

} // namespace pcl_spiral
