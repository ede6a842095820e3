// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Cutters of revolution: tapered bull-nose and its special cases. Lengths in mm.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>

#include <Eigen/Core>

#include <optional>

namespace pcl_spiral {

/** A tapered bull-nose, defined by four lengths and angles. Ball, flat end, bull-nose, taper and tapered ball are special cases. */
struct CutterShape {
  double radius = 0.0;        ///< R, at the upper end of the flank
  double corner_radius = 0.0; ///< r; 0: sharp
  double flank_length = 0.0;  ///< L, along the slant; 0: the cutter ends at the end of the corner
  double flank_angle = 0.0;   ///< alpha, of the flank to the axis, degrees; 0: a cylinder

  /** A ball end on a cylinder. Flank lengths, here and below, are those of the cutting edge above the corner, mm; 0 if they do
   *  not matter. */
  static CutterShape ball(double radius, double flank_length = 0.0);
  static CutterShape flatEnd(double radius, double flank_length = 0.0); ///< A cylinder with a flat end and a sharp edge.
  /** A cylinder with a flat end and a rounded edge of \p corner_radius. */
  static CutterShape bullNose(double radius, double corner_radius, double flank_length = 0.0);
  /** A cone with a flat tip at the lower end of the flank. */
  static CutterShape taper(double radius, double flank_length, double flank_angle);
  /** A cone with a ball that continues it smoothly: r = (R - L sin alpha) / cos alpha. */
  static CutterShape taperedBall(double radius, double flank_length, double flank_angle);
  /** The general case. \p radius at the upper end of the flank, mm; \p flank_angle to the axis, degrees. */
  static CutterShape taperedBullNose(double radius, double corner_radius, double flank_length, double flank_angle);
};

/** The fault of a shape, with the value and the remedy; empty if the shape is a valid cutter. */
Diagnostic faultOf(const CutterShape& shape);

/** Part of a cutter's profile. */
enum class CutterPart {
  Flat,   ///< the disc at the tip
  Corner, ///< the fillet, or the sharp edge where its radius is 0
  Flank   ///< cone or cylinder above the corner
};

/** The place of a cutter that touches a plane at a point. */
struct CutterContact {
  /** False: the plane leans over the flank (n v < sin alpha), and no part of the cutting edge can touch it. The rest
   *  then belongs to the top edge of the flank, the part that would meet the plane first. */
  bool touches = false;
  CutterPart part = CutterPart::Corner;          ///< that touches
  Eigen::Vector3d tip = Eigen::Vector3d::Zero(); ///< the location
  double distance = 0.0;                         ///< of the contact from the axis
  double height = 0.0;                           ///< of the contact above the tip, along the axis
  bool unique = true;        ///< false on the flat and on the flank, which touch along a line or area: the middle of the tip, or the
                             ///< lower end of the flank, was put on the contact
  double excess_angle = 0.0; ///< degrees by which the axis must lean towards the normal before the flank can touch
};

/** Where a surface touches a cutter. */
struct CutterTouch {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();   ///< on the cutter
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ(); ///< unit, of the surface, into the cutter: of a ball (centre - place) / R
};

/** Exact profile of a cutter of revolution.
 *
 *  R1 = R - L sin alpha, R2 = R1 - r cos alpha, H = r - r sin alpha. Height above the tip at the distance l from the axis:
 *  0 up to R2, r - sqrt(r^2 - (l - R2)^2) up to R1, H + (l - R1) / tan alpha up to R. Convex and continuous, and smooth
 *  if r > 0. Source: Sun, Cui, Kang, Wang, five-axis NC toolpath generation from scattered points; its R1 has a
 *  further H sin alpha by misprint.
 */
class CutterProfile {
public:
  /** \throws std::invalid_argument with faultOf(shape) if it is not a valid cutter. */
  explicit CutterProfile(const CutterShape& shape);

  const CutterShape& shape() const { return shape_; }          ///< The lengths and the angle that define it.
  double radius() const { return shape_.radius; }              ///< R
  double cornerRadius() const { return shape_.corner_radius; } ///< r
  double flankRadius() const { return flank_radius_; }         ///< R1, where the flank begins
  double flatRadius() const { return flat_radius_; }           ///< R2, where the corner begins
  double cornerHeight() const { return corner_height_; }       ///< H, where the flank begins
  double topHeight() const { return top_height_; }             ///< where the flank ends
  double flankAngle() const { return flank_angle_; }           ///< alpha, radians

  /** Lowest height of the profile at the distance \p l >= 0 from the axis; infinite beyond R, where there is no profile. */
  double height(double l) const;
  /** Radius of the cutter at \p height above the tip: 0 below the tip, R above the flank's top. */
  double radiusAt(double height) const;
  /** Outward normal at the distance \p l: components away from the axis and along it. At an edge of the profile, the side nearer
   *  to the axis counts. */
  Eigen::Vector2d normal(double l) const;
  /** True if a point at \p l from the axis and \p height above the tip lies inside the cutter by more than \p margin,
   *  measured up the axis. The top is open: the shank continues. */
  bool contains(double l, double height, double margin = 0.0) const { return height - margin > this->height(l); }

  /** Location of the tip for a contact at \p point of a surface with \p normal (unit, out of the material), with the tool along
   *  \p axis (unit, tip to shank): tip = point + l u - z axis, where u is the direction of the normal across the axis. */
  CutterContact locate(const Eigen::Vector3d& point, const Eigen::Vector3d& normal, const Eigen::Vector3d& axis) const;

  /** The reverse of locate: what touches the cutter with its tip at \p tip, along \p axis, next to \p point. The normal is that of the
   *  cutter; only at a sharp edge it is \p normal, of the surface or zero, limited to what can touch there. */
  CutterTouch touchAt(const Eigen::Vector3d& tip, const Eigen::Vector3d& axis, const Eigen::Vector3d& point,
                      const Eigen::Vector3d& normal) const;

private:
  CutterShape shape_;
  double flank_angle_, sin_angle_, cos_angle_;
  double flank_radius_, flat_radius_, corner_height_, top_height_;
};

/** The cutter reduced by \p depth along its normals: a point inside it is deeper than \p depth inside the whole one. Its tip is
 *  \p depth above the tip of the whole one. Returns the cutter itself if nothing would be left. */
CutterProfile insetCutter(const CutterProfile& profile, double depth);

/** Largest distance, mm, between two parallel passes on a plane, with the axis along its normal, that leaves no ridge
 * between them higher than \p scallop, mm: twice the largest distance from the axis at which the profile
 * is not higher than that.
 *
 *  The ridge midway between passes s apart is z(s / 2) high. For a ball that gives 2 sqrt(R^2 - (R - h)^2),
 * for a bull-nose 2 R2 + 2 sqrt(r^2 - (r - h)^2), for a flat end 2 R: its edges meet and leave no ridge. Never
 * more than 2 R. Empty if \p scallop is not above 0. */
std::optional<double> stepForScallop(const CutterProfile& profile, double scallop);

} // namespace pcl_spiral
