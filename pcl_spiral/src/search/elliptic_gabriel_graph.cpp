// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/search/elliptic_gabriel_graph.h>

namespace pcl_spiral {

template class EllipticGabrielGraph<pcl::PointXYZ>;
template class EllipticGabrielGraph<pcl::PointXYZRGB>;
template class EllipticGabrielGraph<pcl::PointNormal>;

} // namespace pcl_spiral
