// SPDX-License-Identifier: BSD-3-Clause
// Points over a surface that a ball must clear.
#include <pcl_spiral/surface/impl/ball_reach.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr double sunk = 0.25; // of the clearance: how far the ball sinks between points of a post

} // namespace

/** The ball is free up to tolerance_ deep in the surface, but not in a measured point. */
void
BallReach::setObstacles(const BallObstacles& obstacles)
{
  clearance_ = obstacles.clearance + 2.0 * tolerance_;
  const double post_step = std::sqrt(8.0 * radius_ * sunk * clearance_); // chord of that sagitta
  std::vector<Eigen::Vector3f> points;
  for (const Eigen::Vector3f& top : obstacles.points) {
    const std::size_t below = patches().feet.nearest(top.cast<double>());
    const Eigen::Vector3f normal = patches().patches[below].normal;
    const Eigen::Vector3f down = -std::max(0.0f, normal.dot(top - patches().feet.point(below))) * normal;
    const int steps = std::max(1, static_cast<int>(std::ceil(down.norm() / post_step)));
    for (int k = 0; k < steps; ++k)
      points.push_back(top + static_cast<float>(k) / static_cast<float>(steps) * down);
  }
  obstacles_ = PointBlocks(std::move(points));
}

bool
BallReach::isCovered(std::size_t i) const
{
  return isNearObstacle(position(i) + radius_ * normal(i), radius_ - tolerance_ + clearance_);
}

bool
BallReach::nearestObstacle(const Eigen::Vector3d& from, double within, Eigen::Vector3d& point) const
{
  if (obstacles_.size() == 0)
    return false;
  const Eigen::Vector3d obstacle = obstacles_.position(obstacles_.nearest(from));
  const double distance = (from - obstacle).norm();
  if (distance - clearance_ >= within)
    return false;
  point = distance > clearance_ ? Eigen::Vector3d(obstacle + clearance_ / distance * (from - obstacle)) : obstacle;
  return true;
}

bool
BallReach::nearest(const Eigen::Vector3d& from, double within, Eigen::Vector3d& point) const
{
  const bool surface = nearestOnSurface(from, within, point);
  return nearestObstacle(from, surface ? (from - point).norm() : within, point) || surface;
}

Eigen::Vector3d
BallReach::overObstacles(const Eigen::Vector3d& centre, const Eigen::Vector3d& up) const
{
  const bool met = isNearObstacle(centre, radius_ - tolerance_ + clearance_) || isNearBeyond(centre, radius_ - tolerance_);
  return met ? freeAlong(centre, up) : centre;
}

} // namespace pcl_spiral
