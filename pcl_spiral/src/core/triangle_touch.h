// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Where a cutter that comes down along its axis touches a flat triangle.
 */
#pragma once

#include <pcl_spiral/core/cutter_profile.h>

#include <Eigen/Core>

#include <limits>

namespace pcl_spiral {

/** What a triangle does to a cutter that comes down on it. */
struct TouchedTriangle {
  bool found = false;                                ///< false: no place of the triangle within the cutter's radius of the axis
  double height = 0.0;                               ///< of the tip along the axis
  Eigen::Vector3d weights = Eigen::Vector3d::Zero(); ///< barycentric, of the place that is touched
};

/** Brings a cutter down on triangles, exactly: the height along the axis less the profile's, h(x) - z(|x|), is concave over a
 *  triangle, whichever side it shows. Where the plane of the triangle is touched within it, that is the place
 *  (\see CutterProfile::locate); otherwise it lies on one of the edges that the touch is outside of. Along an edge, at the
 *  distance p from the axis, it is where the profile's slope along it, z'(l) s / l with l^2 = p^2 + s^2, is the edge's own:
 *  in closed form, but on the corner of a bull-nose, which takes a root of one variable. Ends of edges are the corners. */
class TriangleTouch {
public:
  explicit TriangleTouch(const CutterProfile& profile);

  const CutterProfile& profile() const { return profile_; }

  /** \p corners, one a column: along two directions across the axis, from the axis, and along it. \p wider: the profile is
   *  moved out by it all round, z(l - wider), a bound for triangles that are known across the axis to so much. Triangles whose
   *  plane holds the tip no higher than \p floor may be passed by. */
  TouchedTriangle touch(const Eigen::Matrix3d& corners, double wider = 0.0, double floor = -std::numeric_limits<double>::infinity()) const;

private:
  double heightAt(double l, double wider) const;
  double steepRadius(double slope, double wider) const;
  double alongEdge(double p, double slope, double wider) const;
  double alongCorner(double p, double slope, double wider) const;
  void touchEdge(const Eigen::Matrix3d& corners, int from, double wider, TouchedTriangle& best) const;
  bool touchFace(const Eigen::Matrix3d& corners, double wider, double floor, TouchedTriangle& best) const;

  CutterProfile profile_;
  double cos_angle_, steepest_; ///< of the flank to the axis; the flank's slope, infinite of a cylinder
};

} // namespace pcl_spiral
