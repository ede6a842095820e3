// SPDX-License-Identifier: BSD-3-Clause
#include "way_cover.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr WayPart no_part{1.0, 0.0};

/** Keep the stretch of \p part with \p start + t \p slope >= 0. */
void
clip(double start, double slope, WayPart& part)
{
  if (slope > 0.0)
    part.first = std::max(part.first, -start / slope);
  else if (slope < 0.0)
    part.last = std::min(part.last, -start / slope);
  else if (start < 0.0)
    part = no_part;
}

} // namespace

/** Keep the stretch of \p part with t \p way within \p reach of \p place; false if nothing is left. */
bool
WayCover::clipToReach(const Vector3d& place, const Vector3d& way, double reach, WayPart& part) const
{
  const double squared = way.squaredNorm(), along = place.dot(way), off = place.squaredNorm() - reach * reach;
  const double root = along * along - squared * off;
  if (squared > 0.0 && root >= 0.0) {
    part.first = std::max(part.first, (along - std::sqrt(root)) / squared);
    part.last = std::min(part.last, (along + std::sqrt(root)) / squared);
  }
  else if (squared > 0.0 || off > 0.0)
    part = no_part;
  return part.first <= part.last;
}

/** Where the way is above or below the face. */
WayPart
WayCover::onFace(const Matrix3d& corners, double reach) const
{
  const Vector3d origin = corners.col(0), a = corners.col(1) - origin, b = corners.col(2) - origin, n = a.cross(b);
  const double area = n.norm();
  if (!(area > 0.0))
    return no_part;
  const Vector3d u = b.cross(n), v = n.cross(a); // weights of the second and third corner, times area^2
  WayPart part;
  clip(-origin.dot(u), way_.dot(u), part);
  clip(-origin.dot(v), way_.dot(v), part);
  clip(area * area + origin.dot(u + v), -way_.dot(u + v), part);
  clip(reach * area - origin.dot(n), way_.dot(n), part);
  clip(reach * area + origin.dot(n), -way_.dot(n), part);
  return part;
}

/** Where the way is beside the edge. */
WayPart
WayCover::onEdge(const Vector3d& from, const Vector3d& to, double reach) const
{
  const Vector3d edge = to - from;
  const double squared = edge.squaredNorm();
  if (!(squared > 0.0))
    return no_part;
  WayPart part;
  clip(-from.dot(edge), way_.dot(edge), part);
  clip(to.dot(edge), -way_.dot(edge), part);
  clipToReach(from - from.dot(edge) / squared * edge, way_ - way_.dot(edge) / squared * edge, reach, part);
  return part;
}

void
WayCover::add(const Matrix3d& corners, double reach)
{
  WayPart whole = no_part;
  const auto take = [&](const WayPart& part) {
    if (part.first <= part.last)
      whole = {std::min(whole.first, part.first), std::max(whole.last, part.last)};
  };
  take(onFace(corners, reach));
  for (int k = 0; k < 3; ++k) {
    take(onEdge(corners.col(k), corners.col((k + 1) % 3), reach));
    if (WayPart part; clipToReach(corners.col(k), way_, reach, part))
      take(part);
  }
  if (whole.first <= whole.last)
    parts_.push_back(whole);
}

bool
WayCover::isWhole()
{
  std::sort(parts_.begin(), parts_.end(), [](const WayPart& a, const WayPart& b) { return a.first < b.first; });
  double covered = 0.0;
  for (const WayPart& part : parts_) {
    if (part.first > covered)
      return false;
    covered = std::max(covered, part.last);
  }
  return !parts_.empty() && covered >= 1.0;
}

} // namespace pcl_spiral
