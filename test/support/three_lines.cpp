// SPDX-License-Identifier: BSD-3-Clause
#include "support/three_lines.h"

#include <Eigen/Dense>

#include <cmath>

namespace pcl_spiral::test {

using Eigen::Vector3d;

Vector3d
ThreeLines::position(std::size_t station, double w) const
{
  const Vector3d &start = lines[0][station], &middle = lines[1][station], &end = lines[2][station];
  const Vector3d axis = (middle - start).cross(end - start).normalized();
  // The centre is in the plane of the three points, at equal distance from all.
  Eigen::Matrix3d planes;
  planes << (middle - start).transpose(), (end - start).transpose(), axis.transpose();
  const Vector3d sides((middle - start).dot(0.5 * (middle + start)), (end - start).dot(0.5 * (end + start)), axis.dot(start));
  const Vector3d centre = planes.inverse() * sides, x = start - centre, y = axis.cross(x);
  const auto angle = [&](const Vector3d& p) {
    const double a = std::atan2((p - centre).dot(y), (p - centre).dot(x));
    return a < 0.0 ? a + 2.0 * M_PI : a; // about the axis the arc goes from the start over the middle to the end
  };
  const double at = w * angle(end);
  return centre + std::cos(at) * x + std::sin(at) * y;
}

} // namespace pcl_spiral::test
