// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The strip that the axis of a ball cutter sweeps on a straight move. Private.
 */
#pragma once

#include <pcl_spiral/mesh/impl/patch_tree.h>

#include <Eigen/Core>

namespace pcl_spiral {

/** The flat strip between the axes at both ends of a move, above the way of the ball's centre, without an upper end. The ball and
 *  the shank of the same radius above it sweep all places within the radius of the strip. Squared distances, all in the strip's
 *  frame from the first centre: along the way across the axis, out of the strip's plane, and along the axis. */
class SweptStrip {
public:
  /** \p axis unit. */
  SweptStrip(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Eigen::Vector3d& axis);

  /** \p cell in the frame. */
  PatchCell seen(const PatchCell& cell) const { return {axes_ * (cell.corners.colwise() - origin_), axes_ * cell.bows}; }
  /** The way of the centre, in the frame. */
  Eigen::Vector3d way() const { return {length_, 0.0, rise_}; }

  double toPlace(const Eigen::Vector3d& p) const;
  /** To a box that is not along the frame: a lower bound. */
  double toTurnedBox(const Box& box) const;
  /** To a box along the frame. */
  double toBox(const Eigen::Vector3d& low, const Eigen::Vector3d& high) const;
  /** To the plane of a curved triangle, moved up by its bows (see PatchCell); 0 if the strip is not above
   *  all of it: a lower bound. */
  double toPlane(const Eigen::Matrix3d& corners, const Eigen::Matrix3d& bows) const;
  /** To a flat triangle, exactly: strip and triangle are convex, so if they do not meet, a corner of one or an edge of each
   *  is nearest. */
  double toTriangle(const Eigen::Matrix3d& corners) const;

private:
  double inPlane(double x, double z) const;
  bool meets(const Eigen::Matrix3d& corners) const;
  bool meetsInPlane(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const;
  double toEdge(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;

  Eigen::Vector3d origin_;
  Eigen::Matrix3d axes_, turned_; ///< one a row; the same without signs
  double length_, rise_;          ///< of the lower edge, from (0, 0) to (length, rise)
  double per_squared_;            ///< one over its squared length; 0 of none
};

} // namespace pcl_spiral
