// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/drive/drive_path.h>

namespace pcl_spiral {

template class DrivePath<pcl::PointXYZ>;
template class DrivePath<pcl::PointXYZRGB>;
template class DrivePath<pcl::PointNormal>;

} // namespace pcl_spiral
