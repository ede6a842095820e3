/** \file
 *  The smallest circle about points of a plane.
 */
#pragma once

#include <Eigen/Core>

#include <vector>

namespace pcl_spiral {

struct Circle {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double radius = 0.0;
};

/** The smallest circle that holds all points; radius 0 about the origin without points.
 *  Source: Welzl, Smallest enclosing disks, 1991, in its iterative form; linear time on points in random order. */
Circle
smallestEnclosingCircle(const std::vector<Eigen::Vector2d>& points);

} // namespace pcl_spiral
