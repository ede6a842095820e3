// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/verify/impl/reference_input.h>

namespace pcl_spiral {

template class ReferenceInput<pcl::PointXYZ>;
template class ReferenceInput<pcl::PointXYZRGB>;
template class ReferenceInput<pcl::PointNormal>;

} // namespace pcl_spiral
