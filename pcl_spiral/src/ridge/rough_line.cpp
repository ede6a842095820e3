// SPDX-License-Identifier: BSD-3-Clause
#include "rough_line.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

/** Direction, at \p b, of the circle through three places: the chords, each weighted by the length of the other. */
Vector3d
circleTangent(const Vector3d& a, const Vector3d& b, const Vector3d& c)
{
  const Vector3d before = b - a, after = c - b;
  const double first = before.squaredNorm(), second = after.squaredNorm();
  const Vector3d tangent = second * before + first * after; // of before / first + after / second
  return tangent.norm() > 0.0 ? Vector3d(tangent.normalized()) : Vector3d(after.normalized());
}

/** Direction at the end of the circle that runs along \p tangent at the other end of \p chord. */
Vector3d
mirrored(const Vector3d& tangent, const Vector3d& chord)
{
  const Vector3d along = chord.normalized();
  return 2.0 * tangent.dot(along) * along - tangent;
}

std::vector<Vector3d>
tangentsOf(const Polyline& places, bool closed)
{
  const std::size_t n = places.size();
  std::vector<Vector3d> tangents(n);
  for (std::size_t i = 0; i < n; ++i)
    if (closed || (i > 0 && i + 1 < n))
      tangents[i] = circleTangent(places[(i + n - 1) % n], places[i], places[(i + 1) % n]);
  if (closed)
    return tangents;
  const Vector3d first = places[1] - places[0], last = places[n - 1] - places[n - 2];
  tangents[0] = n > 2 ? mirrored(tangents[1], first) : Vector3d(first.normalized());
  tangents[n - 1] = n > 2 ? mirrored(tangents[n - 2], last) : Vector3d(last.normalized());
  return tangents;
}

} // namespace

Polyline
throughPlaces(const Polyline& places, bool closed, double step)
{
  const std::vector<Vector3d> tangents = tangentsOf(places, closed);
  Polyline line;
  for (std::size_t i = 0; i + (closed ? 0 : 1) < places.size(); ++i) {
    const std::size_t j = (i + 1) % places.size();
    const double chord = (places[j] - places[i]).norm();
    const double turn = std::acos(std::clamp(tangents[i].dot(tangents[j]), -1.0, 1.0));
    const double pull = turn > 1e-3 ? chord * 2.0 * std::tan(turn / 4.0) / std::sin(turn / 2.0) : chord; // of the arc's cubic, at its ends
    const auto pieces = static_cast<int>(std::max(1.0, std::ceil(chord / step)));
    for (int k = 0; k < pieces; ++k) {
      const double t = static_cast<double>(k) / pieces, a = t * t * (3.0 - 2.0 * t);
      line.push_back((1.0 - a) * places[i] + a * places[j] +
                     pull * (t * (1.0 - t) * (1.0 - t) * tangents[i] + t * t * (t - 1.0) * tangents[j]));
    }
  }
  if (!closed)
    line.push_back(places.back());
  return line;
}

} // namespace pcl_spiral
