// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/cleaning/outlier_removal.h>

namespace pcl_spiral {

template class OutlierRemoval<pcl::PointXYZ>;
template class OutlierRemoval<pcl::PointXYZRGB>;
template class OutlierRemoval<pcl::PointXYZI>;
template class OutlierRemoval<pcl::PointNormal>;

} // namespace pcl_spiral
