// SPDX-License-Identifier: BSD-3-Clause
#include "ball_way.h"

#include <pcl_spiral/search/impl/point_blocks.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace pcl_spiral {
namespace {

/** Call \p visit(point, begin, end) for the straight ways of the ball's centre, with the point where each begins. */
template <typename Visit>
void
forWays(const pcl::PointCloud<ToolpathPoint>& path, const std::vector<Eigen::Vector3d>& centres, Visit visit)
{
  for (std::size_t i = 0; i < centres.size(); ++i) {
    const std::size_t next = std::min(i + 1, centres.size() - 1);
    const double distance = (path[next].getVector3fMap() - path[i].getVector3fMap()).norm();
    visit(i, centres[i], isLift(distance, path[next].arc_length - path[i].arc_length) ? centres[i] : centres[next]);
  }
}

/** Adds places on the axis of the shank above the ball, from path points that are a part of the radius apart. */
void
addShank(const pcl::PointCloud<ToolpathPoint>& path, double radius, std::vector<Eigen::Vector3f>& places)
{
  constexpr double apart = 0.25, step = 0.5; // of the radius
  const std::vector<Eigen::Vector3d> centres = ballCentres(path, radius);
  Eigen::Vector3d last = Eigen::Vector3d::Constant(1e30);
  for (std::size_t i = 0; i < centres.size(); ++i) {
    if ((centres[i] - last).norm() < apart * radius)
      continue;
    last = centres[i];
    const Eigen::Vector3d axis(path[i].axis_x, path[i].axis_y, path[i].axis_z);
    for (double above = step; above <= shank_radii; above += step)
      places.push_back((centres[i] + above * radius * axis).cast<float>());
  }
}

/** The deepest of \p points; absent if none is deeper than 0. */
std::optional<BallEntry>
deepestOf(const std::vector<Eigen::Vector3f>& points, const std::vector<double>& depths)
{
  const auto most = std::max_element(depths.begin(), depths.end());
  if (most == depths.end() || !(*most > 0.0))
    return std::nullopt;
  return BallEntry{*most, points[static_cast<std::size_t>(most - depths.begin())].cast<double>()};
}

} // namespace

std::vector<Eigen::Vector3d>
ballCentres(const pcl::PointCloud<ToolpathPoint>& path, double radius)
{
  std::vector<Eigen::Vector3d> centres;
  for (const ToolpathPoint& p : path)
    centres.push_back(p.getVector3fMap().cast<double>() + radius * p.getNormalVector3fMap().cast<double>());
  return centres;
}

std::optional<BallEntry>
deepestEntry(const pcl::PointCloud<ToolpathPoint>& path, const std::vector<Eigen::Vector3d>& centres, double radius,
             const std::vector<Prism>& prisms)
{
  BallEntry deepest;
  forWays(path, centres, [&](std::size_t i, const Eigen::Vector3d& begin, const Eigen::Vector3d& end) {
    for (const Prism& prism : prisms)
      if (const double depth = radius - prism.distance(begin, end); depth > deepest.depth)
        deepest = {depth, path[i].getVector3fMap().cast<double>()};
  });
  return deepest.depth > 0.0 ? std::optional(deepest) : std::nullopt;
}

std::vector<double>
depthsInWay(const pcl::PointCloud<ToolpathPoint>& path, double radius, const std::vector<Eigen::Vector3f>& points)
{
  constexpr double step = 0.02; // of the radius: between places on a way; the depth is then known to a 20000th of the radius
  std::vector<Eigen::Vector3f> places;
  std::vector<double> depths(points.size(), 0.0);
  if (points.empty())
    return depths;
  forWays(path, ballCentres(path, radius), [&](std::size_t, const Eigen::Vector3d& begin, const Eigen::Vector3d& end) {
    const auto pieces = static_cast<int>(std::ceil((end - begin).norm() / (step * radius)));
    for (int k = 0; k < std::max(1, pieces); ++k)
      places.emplace_back((begin + (end - begin) * k / std::max(1, pieces)).cast<float>());
  });
  if (places.empty())
    return depths;
  addShank(path, radius, places);
  const PointBlocks blocks(std::move(places));
#pragma omp parallel for schedule(dynamic, 256)
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(points.size()); ++i)
    if (blocks.box().squaredDistance(points[i].data()) < static_cast<float>(radius * radius)) {
      const Eigen::Vector3d place = points[i].cast<double>();
      depths[i] = std::max(0.0, radius - (blocks.position(blocks.nearest(place)) - place).norm());
    }
  return depths;
}

std::optional<BallEntry>
deepestPoint(const pcl::PointCloud<ToolpathPoint>& path, double radius, const std::vector<Eigen::Vector3f>& points)
{
  return deepestOf(points, depthsInWay(path, radius, points));
}

std::optional<BallEntry>
deepestPoint(const CutterSweep& sweep, const std::vector<Eigen::Vector3f>& points)
{
  std::vector<double> depths(points.size(), 0.0);
#pragma omp parallel for schedule(dynamic, 256)
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(points.size()); ++i)
    depths[i] = sweep.deepest(points[i].cast<double>());
  return deepestOf(points, depths);
}

} // namespace pcl_spiral
