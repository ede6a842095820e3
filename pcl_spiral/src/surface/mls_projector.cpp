// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/surface/mls_projector.h>

namespace pcl_spiral {

template class MLSProjector<pcl::PointXYZ, pcl::PointXYZ>;
template class MLSProjector<pcl::PointXYZ, pcl::PointNormal>;
template class MLSProjector<pcl::PointXYZRGB, pcl::PointXYZRGBNormal>;
template class MLSProjector<pcl::PointNormal, pcl::PointNormal>;

} // namespace pcl_spiral
