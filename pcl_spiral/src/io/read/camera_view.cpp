// SPDX-License-Identifier: BSD-3-Clause
#include "camera_view.h"

#include "core/median.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

/** The pixel \p i; not finite if it has no point. Some cameras write 0 0 0 there. */
Vector3d
pixel(const PointTable& table, std::size_t i)
{
  const Vector3d point(table[0][i], table[1][i], table[2][i]);
  return point.isZero(0.0) ? Vector3d::Constant(NAN) : point;
}

bool
isInACone(const std::vector<Vector3d>& points)
{
  constexpr double least_cosine = 0.5; // 60 degrees
  Vector3d mean = Vector3d::Zero();
  for (const Vector3d& point : points)
    mean += point.normalized();
  mean.normalize();
  return std::all_of(points.begin(), points.end(), [&](const Vector3d& point) { return point.normalized().dot(mean) >= least_cosine; });
}

/** Cells of the image: how far the origin is from their planes, on the side of their first, and their area. */
struct Cells {
  std::vector<double> distances;
  double area = 0.0, turned = 0.0;
};

Cells
cellsOf(const PointTable& table, std::size_t width)
{
  Cells cells;
  for (std::size_t i = 0; i + width < table[0].size(); ++i) {
    if ((i + 1) % width == 0)
      continue;
    const Vector3d at = pixel(table, i), across = (pixel(table, i + 1) - at).cross(pixel(table, i + width) - at);
    const double area = across.norm();
    if (!(area > 0.0)) // or not finite
      continue;
    const double side = at.dot(across) / area;
    cells.distances.push_back(std::abs(side));
    cells.area += area;
    cells.turned += side < 0.0 ? area : 0.0;
  }
  return cells;
}

} // namespace

bool
seenFromOrigin(const PointTable& table, std::size_t width)
{
  constexpr double nearest = 0.2, one_side = 0.9;
  std::vector<Vector3d> points;
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < table[0].size(); ++i)
    if (const Vector3d point = pixel(table, i); point.allFinite()) {
      points.push_back(point);
      box.extend(point);
    }
  Cells cells = cellsOf(table, width);
  if (cells.distances.empty() || !isInACone(points))
    return false;
  return medianOf(std::move(cells.distances)) >= nearest * box.diagonal().norm() &&
         std::max(cells.turned, cells.area - cells.turned) >= one_side * cells.area;
}

} // namespace pcl_spiral
