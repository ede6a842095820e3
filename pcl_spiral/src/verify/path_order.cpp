// SPDX-License-Identifier: BSD-3-Clause
#include "path_order.h"

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/search/impl/point_blocks.h>

#include <Eigen/Geometry>

#include <cstdint>
#include <utility>
#include <vector>

namespace pcl_spiral {
namespace {

constexpr std::size_t most_queries = 1000;
constexpr double most_times = 5.0; // rows at the distance of the points cover the part once; its area is below twice the squared diagonal

/** Half of the points, without a pattern. */
bool
isAsked(std::size_t i)
{
  return (static_cast<std::uint32_t>(i) * 2654435761u >> 31) != 0; // Knuth's multiplicative hash
}

/** Mean distance of a few points of one half from the nearest of the other half; 0 if a half is empty. */
double
usualDistance(const Polyline& points)
{
  std::vector<Eigen::Vector3f> others;
  std::vector<Eigen::Vector3d> asked;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (isAsked(i))
      asked.push_back(points[i]);
    else
      others.push_back(points[i].cast<float>());
  if (others.empty() || asked.empty())
    return 0.0;
  const PointBlocks blocks(std::move(others));
  const std::size_t step = asked.size() / most_queries + 1;
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < asked.size(); i += step, ++count)
    sum += (blocks.position(blocks.nearest(asked[i])) - asked[i]).norm();
  return sum / static_cast<double>(count);
}

} // namespace

Status
checkOrder(const CutterPath& path)
{
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& contact : path.contacts)
    box.extend(contact);
  const double length = cutLength(path), distance = usualDistance(path.contacts);
  if (!(length * distance > most_times * box.sizes().squaredNorm()))
    return Status::success();
  return {StatusCode::InvalidInput,
          Diagnostic("the points are not in the order of the path: as they come, its moves are ",
                     length / static_cast<double>(path.size() - 1), " {mm} long on average, but a point has another ", distance,
                     " {mm} away; give the rows in the order of the path")};
}

} // namespace pcl_spiral
