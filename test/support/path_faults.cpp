// SPDX-License-Identifier: BSD-3-Clause
#include "support/path_faults.h"

#include "support/move_tree.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

#include <omp.h>

namespace pcl_spiral::test {

namespace {

constexpr double rounding = 1e-5; ///< mm: of contacts in single precision, at the size of a part from the origin

/** Distance of \p p to the left of the line from \p a to \p b. */
double
side(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& p)
{
  const Eigen::Vector2d e = b - a, q = p - a;
  return e.norm() > 0.0 ? (e.x() * q.y() - e.y() * q.x()) / e.norm() : 0.0;
}

/** How far the moves \p i and \p j go beyond each other in the tangent plane at \p i; 0 if they do not cross.
 */
double
crossingDepth(const CheckedPath& path, std::size_t i, std::size_t j)
{
  const Eigen::Vector3d e = path.normals[i].unitOrthogonal(), f = path.normals[i].cross(e);
  const auto plane = [&](std::size_t k) {
    const Eigen::Vector3d d = path.contacts[k] - path.contacts[i];
    return Eigen::Vector2d(d.dot(e), d.dot(f));
  };
  const Eigen::Vector2d a = plane(i), b = plane(i + 1), c = plane(j), d = plane(j + 1);
  const std::array<double, 4> s{side(c, d, a), side(c, d, b), side(a, b, c), side(a, b, d)};
  if (!(s[0] * s[1] < 0.0 && s[2] * s[3] < 0.0))
    return 0.0;
  return std::min({std::abs(s[0]), std::abs(s[1]), std::abs(s[2]), std::abs(s[3])});
}

} // namespace

std::vector<Place>
strictCrossings(const AnalyticSurface& surface, const CheckedPath& path, int threads)
{
  std::vector<Place> found;
  if (path.size() < 4)
    return found;
  std::vector<Eigen::Vector3d> chart(path.size()); // moves that cross in a tangent plane overlap here
  for (std::size_t i = 0; i < path.size(); ++i)
    chart[i] << surface.chart(path.contacts[i]), 0.0;
  const MoveTree tree(std::move(chart));
  const int team = threads > 0 ? threads : omp_get_max_threads();
#pragma omp parallel for schedule(dynamic, 512) num_threads(team)
  for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(tree.moves()); ++i)
    tree.laterOverlaps(static_cast<std::size_t>(i), [&](std::size_t j) {
      const auto at = static_cast<std::size_t>(i);
      const double depth = j > at + 1 && !path.isLift(at) && !path.isLift(j) ? crossingDepth(path, at, j) : 0.0;
      if (depth > rounding) {
        const Place place{depth, path.contacts[at], surface.rimDistance(path.contacts[at]), path.turn(at), at};
#pragma omp critical
        found.push_back(place);
      }
    });
  std::sort(found.begin(), found.end(),
            [](const Place& a, const Place& b) { return a.value != b.value ? a.value > b.value : a.index < b.index; });
  return found;
}

std::vector<Place>
jumps(const CheckedPath& path, double longest)
{
  std::vector<Place> found;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const double length = (path.contacts[i + 1] - path.contacts[i]).norm();
    if (!(length <= longest) && !path.isLift(i))
      found.push_back({length, path.contacts[i], 0.0, path.turn(i), i});
  }
  return found;
}

} // namespace pcl_spiral::test
