// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/verify/lead_check.h>

namespace pcl_spiral {

template class LeadCheck<pcl::PointXYZ>;
template class LeadCheck<pcl::PointXYZRGB>;
template class LeadCheck<pcl::PointNormal>;

} // namespace pcl_spiral
