// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/cleaning/ball_closing.h>

namespace pcl_spiral {

template class BallClosing<pcl::PointXYZ>;
template class BallClosing<pcl::PointXYZRGB>;
template class BallClosing<pcl::PointXYZI>;
template class BallClosing<pcl::PointNormal>;

} // namespace pcl_spiral
