// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/spiral/loop_linking.h>
#include <pcl_spiral/spiral/scallop_loops.h>
#include <pcl_spiral/spiral/step_over_field.h>

namespace pcl_spiral {

template class StepOverField<pcl::PointXYZ>;
template class StepOverField<pcl::PointXYZRGB>;
template class StepOverField<pcl::PointNormal>;
template class ScallopLoops<pcl::PointXYZ>;
template class ScallopLoops<pcl::PointXYZRGB>;
template class ScallopLoops<pcl::PointNormal>;
template class LoopLinking<pcl::PointXYZ>;
template class LoopLinking<pcl::PointXYZRGB>;
template class LoopLinking<pcl::PointNormal>;

} // namespace pcl_spiral
