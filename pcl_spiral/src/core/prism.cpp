// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/core/prism.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace pcl_spiral {
namespace {

double
cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

double
distanceToSide(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  const Eigen::Vector2d side = b - a;
  const double length = side.squaredNorm();
  const double along = length > 0.0 ? std::clamp((p - a).dot(side) / length, 0.0, 1.0) : 0.0;
  return (a + along * side - p).norm();
}

bool
sidesCross(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c, const Eigen::Vector2d& d)
{
  const auto apart = [](const Eigen::Vector2d& p, const Eigen::Vector2d& q, const Eigen::Vector2d& r, const Eigen::Vector2d& s) {
    return cross(q - p, r - p) * cross(q - p, s - p) >= 0.0;
  };
  return !apart(a, b, c, d) && !apart(c, d, a, b);
}

double
distanceOfSides(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c, const Eigen::Vector2d& d)
{
  if (sidesCross(a, b, c, d))
    return 0.0;
  return std::min({distanceToSide(a, c, d), distanceToSide(b, c, d), distanceToSide(c, a, b), distanceToSide(d, a, b)});
}

} // namespace

Eigen::Vector3d
polygonArea(const std::vector<Eigen::Vector3d>& corners)
{
  Eigen::Vector3d twice = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i)
    twice += (corners[i] - corners[0]).cross(corners[(i + 1) % corners.size()] - corners[0]);
  return 0.5 * twice;
}

Prism::Prism(const std::vector<Eigen::Vector3d>& corners, const Eigen::Vector3d& axis) : axis_(axis.normalized())
{
  across_[0] = axis_.unitOrthogonal();
  across_[1] = axis_.cross(across_[0]);
  for (const Eigen::Vector3d& corner : corners)
    if (corners_.empty() || flat(corner) != corners_.back())
      corners_.push_back(flat(corner));
  if (corners_.size() > 1 && corners_.front() == corners_.back()) // closed in its file
    corners_.pop_back();
  fault_ = findFault(corners);
}

Diagnostic
Prism::findFault(const std::vector<Eigen::Vector3d>& corners) const
{
  constexpr double flat_share = 1e-9; // of the squared circumference
  const std::size_t n = corners_.size();
  if (n < 3)
    return Diagnostic("it has ", n, " different corners, and a polygon has three or more");
  double area = 0.0, around = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    area += 0.5 * cross(corners_[i] - corners_[0], corners_[(i + 1) % n] - corners_[0]);
    around += (corners_[(i + 1) % n] - corners_[i]).norm();
  }
  for (std::size_t i = 0; i + 2 < n; ++i)
    for (std::size_t j = i + 2; j < n; ++j)
      if (sidesCross(corners_[i], corners_[i + 1], corners_[j], corners_[(j + 1) % n]))
        return Diagnostic("its side from ", Place(corners[std::min(i, corners.size() - 1)]), " crosses another side");
  if (!(std::abs(area) > flat_share * around * around))
    return "all its corners lie on one line, so it has no area";
  return {};
}

bool
Prism::contains(const Eigen::Vector3d& place) const
{
  const Eigen::Vector2d p = flat(place);
  bool inside = false;
  for (std::size_t i = 0, before = corners_.size() - 1; i < corners_.size(); before = i++) {
    const Eigen::Vector2d &a = corners_[before], &b = corners_[i];
    if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()))
      inside = !inside;
  }
  return inside;
}

std::vector<Eigen::Vector3d>
Prism::outline(double step) const
{
  std::vector<Eigen::Vector3d> places;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const Eigen::Vector2d side = corners_[(i + 1) % corners_.size()] - corners_[i];
    const int steps = std::max(1, static_cast<int>(std::ceil(side.norm() / step)));
    for (int k = 0; k < steps; ++k) {
      const Eigen::Vector2d flat = corners_[i] + side * k / steps;
      places.emplace_back(flat.x() * across_[0] + flat.y() * across_[1]);
    }
  }
  return places;
}

double
Prism::width() const
{
  double largest = 0.0;
  for (const Eigen::Vector2d& a : corners_)
    for (const Eigen::Vector2d& b : corners_)
      largest = std::max(largest, (a - b).norm());
  return largest;
}

double
Prism::distance(const Eigen::Vector3d& place) const
{
  return distance(place, place);
}

double
Prism::distance(const Eigen::Vector3d& begin, const Eigen::Vector3d& end) const
{
  if (contains(begin))
    return 0.0;
  const Eigen::Vector2d a = flat(begin), b = flat(end);
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0, before = corners_.size() - 1; i < corners_.size(); before = i++)
    least = std::min(least, distanceOfSides(a, b, corners_[before], corners_[i]));
  return least;
}

} // namespace pcl_spiral
