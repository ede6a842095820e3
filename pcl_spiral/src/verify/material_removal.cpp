// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/verify/material_removal.h>

namespace pcl_spiral {

template class MaterialRemoval<pcl::PointXYZ>;
template class MaterialRemoval<pcl::PointXYZRGB>;
template class MaterialRemoval<pcl::PointNormal>;

} // namespace pcl_spiral
