// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>

namespace pcl_spiral {

template class SpiralToolpathGenerator<pcl::PointXYZ>;
template class SpiralToolpathGenerator<pcl::PointXYZRGB>;
template class SpiralToolpathGenerator<pcl::PointNormal>;

} // namespace pcl_spiral
