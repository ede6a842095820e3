// SPDX-License-Identifier: BSD-3-Clause
#include "shank_room.h"

#include <pcl_spiral/core/impl/pass_ranges.h>
#include <pcl_spiral/core/tool_holder.h>
#include <pcl_spiral/search/impl/point_blocks.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

constexpr double apart = 0.1; // of the radius: between shanks that are looked at on a move
constexpr int lean_steps = 15;

/** A tool: its ball's centre, the normal there and its axis. */
struct Tool {
  Vector3d centre, normal, axis;
};

/** Shanks beside points. */
class ShankRoom {
public:
  ShankRoom(const std::vector<Eigen::Vector3f>& obstacles, double radius) : obstacles_(obstacles), radius_(radius) {}

  double share(const Tool& tool) const;
  double share(const Tool& from, const Tool& to) const;

private:
  std::vector<Vector3d> nearLeaning(const Tool& tool) const;
  bool isClear(const Vector3d& axis, const std::vector<Vector3d>& points) const;

  PointBlocks obstacles_;
  double radius_;
};

/** Obstacles beside the plane in which the shank of \p tool leans, relative to the centre. */
std::vector<Vector3d>
ShankRoom::nearLeaning(const Tool& tool) const
{
  const double reach = (shank_radii + 1.0) * radius_;
  const auto squared = static_cast<float>(reach * reach);
  const Eigen::Vector3f centre = tool.centre.cast<float>();
  const Vector3d across = tool.normal.cross(tool.axis).normalized();
  std::vector<Vector3d> points;
  obstacles_.forBlocks([&](const Box& box) { return box.squaredDistance(centre.data()) <= squared; },
                       [&](std::size_t block) {
                         for (std::size_t i = obstacles_.blockBegin(block); i < obstacles_.blockEnd(block); ++i)
                           if (const Vector3d p = obstacles_.position(i) - tool.centre; std::abs(p.dot(across)) < radius_)
                             points.push_back(p);
                       });
  return points;
}

/** \p points relative to the centre of the ball. Below the centre is the ball, which rides over them. */
bool
ShankRoom::isClear(const Vector3d& axis, const std::vector<Vector3d>& points) const
{
  return std::none_of(points.begin(), points.end(), [&](const Vector3d& p) {
    const double along = p.dot(axis);
    return along > 0.0 && along < shank_radii * radius_ && (p - along * axis).squaredNorm() < radius_ * radius_;
  });
}

double
ShankRoom::share(const Tool& tool) const
{
  const std::vector<Vector3d> points = nearLeaning(tool);
  if (points.empty())
    return 1.0;
  int step = 0;
  while (step <= lean_steps && isClear(leaned(tool.normal, tool.axis, double(step) / lean_steps), points))
    ++step;
  return std::max(0, step - 1) / double(lean_steps);
}

/** The least on the straight move of the ball. */
double
ShankRoom::share(const Tool& from, const Tool& to) const
{
  const double way = std::max((to.centre - from.centre).norm(), shank_radii * radius_ * (to.axis - from.axis).norm());
  const int pieces = std::max(1, static_cast<int>(std::ceil(way / (apart * radius_))));
  double least = 1.0;
  for (int k = 0; k <= pieces && least > 0.0; ++k) {
    const double part = double(k) / pieces;
    const auto between = [part](const Vector3d& a, const Vector3d& b) -> Vector3d { return a + part * (b - a); };
    least = std::min(least, share({between(from.centre, to.centre), between(from.normal, to.normal).normalized(),
                                   between(from.axis, to.axis).normalized()}));
  }
  return least;
}

/** Lowers \p shares, one for each point of the pass, until none differs from the next by more than \p rate for each mm. */
void
limitRate(const Polyline& feet, const PassRange& pass, double rate, std::vector<double>& shares)
{
  const auto step = [&](std::size_t i) { return rate * (feet[i] - feet[i - 1]).norm(); };
  for (std::size_t i = pass.begin + 1; i < pass.end; ++i)
    shares[i] = std::min(shares[i], shares[i - 1] + step(i));
  for (std::size_t i = pass.end; i-- > pass.begin + 1;)
    shares[i - 1] = std::min(shares[i - 1], shares[i] + step(i));
}

} // namespace

Vector3d
leaned(const Vector3d& normal, const Vector3d& axis, double share)
{
  return (normal + share * (axis - normal)).normalized();
}

std::vector<double>
leanShares(const SpiralPath& path, const std::vector<Vector3d>& axes, const std::vector<Eigen::Vector3f>& obstacles, double radius,
           double rate)
{
  const ShankRoom room(obstacles, radius);
  const auto tool = [&](std::size_t i) { return Tool{path.contacts[i] + radius * path.normals[i], path.normals[i], axes[i]}; };
  const auto size = static_cast<std::int64_t>(axes.size());
  std::vector<double> on_moves(axes.size()), shares(axes.size()); // of the move to the next point
#pragma omp parallel for schedule(dynamic, 256)
  for (std::int64_t i = 0; i < size; ++i)
    on_moves[i] = i + 1 < size && !beginsPass(path.passes, i + 1) ? room.share(tool(i), tool(i + 1)) : room.share(tool(i));
  for (std::size_t i = 0; i < axes.size(); ++i)
    shares[i] = i > 0 && !beginsPass(path.passes, i) ? std::min(on_moves[i - 1], on_moves[i]) : on_moves[i];
  for (const PassRange& pass : passRanges(path.passes, axes.size()))
    limitRate(path.onSurface(), pass, rate, shares);
  return shares;
}

} // namespace pcl_spiral
