// SPDX-License-Identifier: BSD-3-Clause
#include "tilted_axes.h"

#include "core/parallel_resize.h"

#include <Eigen/Geometry>

#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace pcl_spiral {

namespace {

using Eigen::Vector3d;
using Vectors = std::vector<Vector3d>;

/** Feed direction of the points \p first to \p end, which all lie at one place. */
Vector3d
chordAt(const Polyline& points, std::size_t first, std::size_t end)
{
  const Vector3d back = first > 0 ? Vector3d(points[first] - points[first - 1]) : Vector3d(Vector3d::Zero());
  const Vector3d ahead = end < points.size() ? Vector3d(points[end] - points[first]) : Vector3d(Vector3d::Zero());
  const double f = back.squaredNorm(), g = ahead.squaredNorm();
  return f > 0.0 && g > 0.0 ? Vector3d(back / f + ahead / g) : Vector3d(back + ahead);
}

Vector3d
tangentialPart(const Vector3d& chord, const Vector3d& normal)
{
  const Vector3d tangential = chord - normal * normal.dot(chord);
  return tangential.norm() > 1e-9 * chord.norm() ? tangential.normalized() : Vector3d(Vector3d::Zero());
}

/** Call \p visit(i, feed) for every point, in parallel. */
template <typename Visit>
void
forEachFeed(const Polyline& points, const Vectors& normals, Visit visit)
{
  const auto n = static_cast<std::int64_t>(points.size());
#pragma omp parallel for schedule(static)
  for (std::int64_t first = 0; first < n; ++first) {
    if (first > 0 && points[first] == points[first - 1])
      continue; // done with the first point of its run
    std::int64_t end = first + 1;
    while (end < n && points[end] == points[first])
      ++end;
    const Vector3d chord = chordAt(points, first, end);
    for (std::int64_t i = first; i < end; ++i)
      visit(i, tangentialPart(chord, normals[i]));
  }
}

/** Two angles, ready to be applied at many points. */
struct Tilt {
  Tilt(double side_tilt, double lead)
  : side_cos(std::cos(side_tilt)), side_sin(std::sin(side_tilt)), lead_cos(std::cos(lead)), lead_sin(std::sin(lead))
  {}

  Vector3d axis(const Vector3d& normal, const Vector3d& feed) const
  {
    if (feed.isZero(0.0))
      return normal;
    const Vector3d sideways = side_cos * normal + side_sin * feed.cross(normal);
    return (lead_cos * sideways + lead_sin * feed).normalized();
  }

  double side_cos, side_sin, lead_cos, lead_sin;
};

void
checkSizes(const Polyline& points, const Vectors& normals)
{
  if (points.size() != normals.size())
    throw std::invalid_argument("feedDirections: give one normal per point");
}

} // namespace

std::vector<Vector3d>
feedDirections(const Polyline& points, const Vectors& normals)
{
  checkSizes(points, normals);
  Vectors feeds(points.size());
  forEachFeed(points, normals, [&](std::size_t i, const Vector3d& feed) { feeds[i] = feed; });
  return feeds;
}

Vector3d
tiltedAxis(const Vector3d& normal, const Vector3d& feed, double side_tilt, double lead)
{
  return Tilt(side_tilt, lead).axis(normal, feed);
}

Vectors
tiltedAxes(const Polyline& points, const Vectors& normals, double side_tilt, double lead)
{
  const double right_angle = std::acos(0.0);
  if (!(std::abs(side_tilt) < right_angle) || !(std::abs(lead) < right_angle))
    throw std::invalid_argument("tiltedAxes: side tilt and lead must be under 90 degrees");
  checkSizes(points, normals);
  const Tilt tilt(side_tilt, lead);
  Vectors axes;
  resizeInParallel(axes, points.size());
  forEachFeed(points, normals, [&](std::size_t i, const Vector3d& feed) { axes[i] = tilt.axis(normals[i], feed); });
  return axes;
}

} // namespace pcl_spiral
