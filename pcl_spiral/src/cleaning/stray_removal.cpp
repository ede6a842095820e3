// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/cleaning/stray_removal.h>

namespace pcl_spiral {

template class StrayRemoval<pcl::PointXYZ>;
template class StrayRemoval<pcl::PointXYZRGB>;
template class StrayRemoval<pcl::PointXYZI>;
template class StrayRemoval<pcl::PointNormal>;

} // namespace pcl_spiral
