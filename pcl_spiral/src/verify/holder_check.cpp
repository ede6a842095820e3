// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/verify/holder_check.h>

namespace pcl_spiral {

template class HolderCheck<pcl::PointXYZ>;
template class HolderCheck<pcl::PointXYZRGB>;
template class HolderCheck<pcl::PointNormal>;

} // namespace pcl_spiral
