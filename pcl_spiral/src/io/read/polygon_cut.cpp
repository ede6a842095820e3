// SPDX-License-Identifier: BSD-3-Clause
#include "polygon_cut.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>

namespace pcl_spiral {
namespace {

/** Shares of the polygon's size within which a corner is on a line: the precision of single-precision coordinates. */
constexpr double flat = 1e-7;

double
cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/** Whether \p c and \p d are on different sides of the line from \p a to \p b. */
bool
parts(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c, const Eigen::Vector2d& d)
{
  const double least = flat * (b - a).norm();
  const double one = cross(b - a, c - a), other = cross(b - a, d - a);
  return (one > least && other < -least) || (one < -least && other > least);
}

/** Newell's normal, of any length; zero if the polygon has no area. */
Eigen::Vector3d
normalOf(const std::vector<Eigen::Vector3d>& corners)
{
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    normal += (corners[i] - corners[0]).cross(corners[i + 1] - corners[0]);
  return normal;
}

} // namespace

PolygonCut::PolygonCut(const std::vector<Eigen::Vector3d>& corners)
{
  double size = 0.0;
  for (const Eigen::Vector3d& corner : corners)
    size = std::max(size, (corner - corners[0]).norm());
  std::vector<Eigen::Vector3d> shares;
  shares.reserve(corners.size());
  for (const Eigen::Vector3d& corner : corners)
    shares.push_back(size > 0.0 ? ((corner - corners[0]) / size).eval() : Eigen::Vector3d::Zero());
  const Eigen::Vector3d normal = normalOf(shares);
  const bool area = normal.norm() > flat;
  const Eigen::Vector3d up = area ? normal.normalized() : Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d u = up.unitOrthogonal();
  const Eigen::Vector3d v = up.cross(u);
  for (const Eigen::Vector3d& share : shares)
    corners_.emplace_back(share.dot(u), share.dot(v));
  left_.resize(corners.size());
  std::iota(left_.begin(), left_.end(), std::size_t{0});
}

bool
PolygonCut::convex() const
{
  const std::size_t n = corners_.size();
  for (std::size_t i = 0; i < n; ++i)
    if (shape((i + n - 1) % n, i, (i + 1) % n) <= flat)
      return false;
  for (std::size_t i = 2; i < n; ++i) // more than once round, some are behind the first side or the fan turns back
    if (cross(corners_[1] - corners_[0], corners_[i] - corners_[0]) <= 0.0 || shape(0, i - 1, i) <= flat)
      return false;
  return true;
}

std::vector<CutTriangle>
PolygonCut::fan() const
{
  std::vector<CutTriangle> triangles;
  for (std::size_t i = 2; i < corners_.size(); ++i)
    triangles.push_back({0, i - 1, i});
  return triangles;
}

std::vector<CutTriangle>
PolygonCut::ears()
{
  faulty_ = crossesItself();
  std::vector<CutTriangle> triangles;
  values_.resize(left_.size());
  for (std::size_t place = 0; place < left_.size(); ++place)
    values_[place] = valueOf(place);
  while (left_.size() > 2)
    cutOff(static_cast<std::size_t>(std::max_element(values_.begin(), values_.end()) - values_.begin()), triangles);
  return triangles;
}

/** Whether two sides cross and do not only touch. */
bool
PolygonCut::crossesItself() const
{
  const std::size_t n = corners_.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 2; j < n; ++j) {
      const Eigen::Vector2d &a = corners_[i], &b = corners_[i + 1], &c = corners_[j], &d = corners_[(j + 1) % n];
      if (parts(a, b, c, d) && parts(c, d, a, b))
        return true;
    }
  return false;
}

/** Twice the area over the sum of the squared sides: 0.29 for equal sides, 0 for a flat triangle, negative for one that turns
 * the other way. */
double
PolygonCut::shape(std::size_t before, std::size_t at, std::size_t after) const
{
  const Eigen::Vector2d a = corners_[at] - corners_[before], b = corners_[after] - corners_[at];
  const double sides = a.squaredNorm() + b.squaredNorm() + (a + b).squaredNorm();
  return sides > 0.0 ? cross(a, b) / sides : 0.0;
}

/** No other remaining corner is in the triangle or on its sides. Corners at the same place as its own corners do
 * not count: a hole joined to the outline by a double side has such corners. */
bool
PolygonCut::empty(std::size_t before, std::size_t at, std::size_t after) const
{
  const std::array<Eigen::Vector2d, 3> own{corners_[before], corners_[at], corners_[after]};
  std::array<Eigen::Vector2d, 3> side;
  for (std::size_t k = 0; k < 3; ++k)
    side[k] = (own[(k + 1) % 3] - own[k]).normalized();
  return std::none_of(left_.begin(), left_.end(), [&](std::size_t other) {
    const Eigen::Vector2d& p = corners_[other];
    for (std::size_t k = 0; k < 3; ++k)
      if (p == own[k] || cross(side[k], p - own[k]) < -flat)
        return false;
    return true;
  });
}

/** The shape if the corner is an ear; otherwise below 0, corners that turn the right way before the others. */
double
PolygonCut::valueOf(std::size_t place) const
{
  const std::size_t n = left_.size();
  const std::size_t before = left_[(place + n - 1) % n], at = left_[place], after = left_[(place + 1) % n];
  const double value = shape(before, at, after);
  if (value <= flat)
    return value - 1.0;
  return empty(before, at, after) ? value : -1.0 / (1.0 + value);
}

void
PolygonCut::cutOff(std::size_t place, std::vector<CutTriangle>& triangles)
{
  faulty_ = faulty_ || values_[place] < 0.0;
  const std::size_t n = left_.size();
  triangles.push_back({left_[(place + n - 1) % n], left_[place], left_[(place + 1) % n]});
  left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(place));
  values_.erase(values_.begin() + static_cast<std::ptrdiff_t>(place));
  for (const std::size_t neighbour : {(place + n - 2) % (n - 1), place % (n - 1)})
    values_[neighbour] = valueOf(neighbour);
}

} // namespace pcl_spiral
