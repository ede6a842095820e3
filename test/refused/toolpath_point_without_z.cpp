// SPDX-License-Identifier: BSD-3-Clause
// Must not compile: a point of a toolpath without z. The compiler's message must name the remedy.
#include <pcl_spiral/common/impl/toolpath_fields.h>

struct FlatPoint {
  float x = 0.0f, y = 0.0f;
};
POINT_CLOUD_REGISTER_POINT_STRUCT(FlatPoint, (float, x, x)(float, y, y))

int
main()
{
  FlatPoint point;
  pcl_spiral::ToolpathFields<FlatPoint>::set(point, Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ(), Eigen::Vector3f::UnitZ(), 0.0, 0.0f,
                                             false);
}
