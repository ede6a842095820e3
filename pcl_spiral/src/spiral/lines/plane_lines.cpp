// SPDX-License-Identifier: BSD-3-Clause
#include "plane_lines.h"

#include <algorithm>

namespace pcl_spiral {
namespace {

double
side(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& p)
{
  return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
}

bool
cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c, const Eigen::Vector2d& d)
{
  return side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0;
}

} // namespace

PlaneLines::PlaneLines(const Eigen::Vector3d& origin, const Eigen::Vector3d& along, const Eigen::Vector3d& across)
: origin_(origin), e1_(along.normalized()), e2_((across - across.dot(e1_) * e1_).normalized())
{}

Eigen::Vector2d
PlaneLines::inPlane(const Eigen::Vector3d& p) const
{
  return {(p - origin_).dot(e1_), (p - origin_).dot(e2_)};
}

void
PlaneLines::add(const Polyline& line)
{
  for (std::size_t i = 1; i < line.size(); ++i)
    segments_.push_back({inPlane(line[i - 1]), inPlane(line[i])});
}

bool
PlaneLines::crossedBy(const Polyline& line) const
{
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Eigen::Vector2d a = inPlane(line[i - 1]), b = inPlane(line[i]);
    if (std::any_of(segments_.begin(), segments_.end(), [&](const Segment& s) { return cross(a, b, s[0], s[1]); }))
      return true;
  }
  return false;
}

} // namespace pcl_spiral
