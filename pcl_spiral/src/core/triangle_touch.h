// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Where a cutter that comes down along its axis touches a flat triangle.
 */
#pragma once

#include <pcl_spiral/core/cutter_profile.h>

#include <Eigen/Core>

#include <limits>

namespace pcl_spiral {

/** Where a triangle stops a cutter that comes down on it. */
struct TouchedTriangle {
  bool found = false;                                ///< false: no place of the triangle is within the cutter radius of the axis
  double height = 0.0;                               ///< of the tip along the axis
  Eigen::Vector3d weights = Eigen::Vector3d::Zero(); ///< barycentric weights of the place touched
};

/** Brings a cutter down on triangles, exactly: the height along the axis less that of the profile, h(x) - z(|x|), is concave over a
 *  triangle, whichever side faces the cutter. If the plane of the triangle is touched within it, that is the place
 *  (\see CutterProfile::locate). Otherwise the touch lies on one of the edges that the touch of the plane is outside of. Along an edge,
 *  at the distance p from the axis, the slope of the profile there, z'(l) s / l with l^2 = p^2 + s^2, equals that of the edge: in
 *  closed form, except on the corner of a bull-nose, which takes a root of one variable. The ends of the edges are the corners. */
class TriangleTouch {
public:
  explicit TriangleTouch(const CutterProfile& profile);

  const CutterProfile& profile() const { return profile_; }

  /** \p corners, one per column: along two directions across the axis, from the axis, and along it. \p wider: the profile is
   *  moved outwards by it all round, z(l - wider): a bound for triangles whose place across the axis is known only to this. Triangles
   *  whose plane holds the tip no higher than \p floor may be skipped. */
  TouchedTriangle touch(const Eigen::Matrix3d& corners, double wider = 0.0, double floor = -std::numeric_limits<double>::infinity()) const;

private:
  double heightAt(double l, double wider) const;
  double steepRadius(double slope, double wider) const;
  double alongEdge(double p, double slope, double wider) const;
  double alongCorner(double p, double slope, double wider) const;
  void touchEdge(const Eigen::Matrix3d& corners, int from, double wider, TouchedTriangle& best) const;
  bool touchFace(const Eigen::Matrix3d& corners, double wider, double floor, TouchedTriangle& best) const;

  CutterProfile profile_;
  double cos_angle_, steepest_; ///< of the flank to the axis; slope of the flank, infinite for a cylinder
};

} // namespace pcl_spiral
