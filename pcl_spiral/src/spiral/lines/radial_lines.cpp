// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/spiral/radial_lines.h>

namespace pcl_spiral {

template class RadialLines<pcl::PointXYZ>;
template class RadialLines<pcl::PointXYZRGB>;
template class RadialLines<pcl::PointNormal>;

} // namespace pcl_spiral
