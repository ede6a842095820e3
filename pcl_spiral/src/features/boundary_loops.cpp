// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/features/boundary_loops.h>

namespace pcl_spiral {

template class BoundaryLoops<pcl::PointXYZ>;
template class BoundaryLoops<pcl::PointXYZRGB>;
template class BoundaryLoops<pcl::PointNormal>;

} // namespace pcl_spiral
