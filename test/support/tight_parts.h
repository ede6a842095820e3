// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Parts with places that a ball does not reach, known exactly. Lengths in mm.
 */
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Core>

#include <vector>

namespace pcl_spiral::test {

/** An arc of a profile, from angle a to angle b about its centre; with radius 0 the segment from begin to end. */
struct ProfilePiece {
  Eigen::Vector2d begin, end, centre;
  double radius = 0.0, a = 0.0, b = 0.0;

  double length() const;
  Eigen::Vector2d at(double share) const;
  double distance(const Eigen::Vector2d& p) const; ///< unsigned
};

ProfilePiece segment(const Eigen::Vector2d& begin, const Eigen::Vector2d& end);
ProfilePiece arc(const Eigen::Vector2d& centre, double radius, double a, double b);

/** A profile (across, z) moved along y, or turned about the z axis. The material is below. */
struct TightPart {
  std::vector<ProfilePiece> profile;
  bool turned = false;
  double half_width = 0.0; ///< along y

  /** Unsigned distance of \p p from the surface, which goes on along y. */
  double distance(const Eigen::Vector3d& p) const;
  /** Points about \p spacing apart, shaken a little, with noise. */
  pcl::PointCloud<pcl::PointXYZ>::Ptr scan(double spacing, double noise, unsigned int seed) const;
};

/** Two planes that rise by \p slope, radians, from a fillet of radius \p fillet about (0, fillet), \p reach wide on either side. */
TightPart valley(double slope, double fillet, double reach, double half_width);
/** Height above the lowest point of the centre of a ball that rests in the valley. */
double valleyCentre(double slope, double fillet, double ball);

/** The plane z = 0 out to \p reach, with a hemispherical pit of radius \p pit about the origin. Its rim is rounded with radius \p rim. */
TightPart pittedPlane(double pit, double rim, double reach);
/** Height of the centre of a ball that rests on the rim. */
double pitCentre(double pit, double rim, double ball);

/** A hemisphere of radius \p ball on the plane z = 0, with a fillet between them. */
TightPart ballOnPlane(double sphere, double fillet, double reach);
/** Distance from the axis of the centre of a ball that lies on the plane beside the sphere. */
double besideSphere(double sphere, double ball);

} // namespace pcl_spiral::test
