// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/cleaning/part_region.h>

namespace pcl_spiral {

template class PartRegion<pcl::PointXYZ>;
template class PartRegion<pcl::PointXYZRGB>;
template class PartRegion<pcl::PointXYZI>;
template class PartRegion<pcl::PointNormal>;

} // namespace pcl_spiral
