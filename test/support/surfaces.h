// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Surfaces known exactly: the reference paths are judged by. Lengths in mm.
 */
#pragma once

#include "support/region.h"

#include <pcl_spiral/core/polyline.h>

#include <Eigen/Core>

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace pcl_spiral::test {

/** A bounded piece of an implicit surface F = 0 with a chart (u, v) and an outline given in the chart.
 *
 *  F grows out of the material, towards the cutter; curvature is positive where the material is
 * convex. Positions, normals and distances are those of the whole surface, also beyond the outline.
 */
class AnalyticSurface {
public:
  explicit AnalyticSurface(Region region) : region_(std::move(region)) {}
  virtual ~AnalyticSurface() = default;

  virtual double value(const Eigen::Vector3d& x) const = 0;
  virtual Eigen::Vector3d gradient(const Eigen::Vector3d& x) const = 0;
  virtual Eigen::Matrix3d hessian(const Eigen::Vector3d& x) const = 0;
  /** Point of the surface at the parameters, and back. */
  virtual Eigen::Vector3d lift(const Eigen::Vector2d& u) const = 0;
  virtual Eigen::Vector2d chart(const Eigen::Vector3d& x) const = 0;
  /** dA / du dv. */
  virtual double areaElement(const Eigen::Vector2d& u) const = 0;

  const Region& region() const { return region_; }
  Eigen::Vector3d normal(const Eigen::Vector3d& x) const { return gradient(x).normalized(); }
  /** Normal curvature in the direction of \p d, 1/mm. */
  double normalCurvature(const Eigen::Vector3d& x, const Eigen::Vector3d& d) const;
  /** Smallest and largest normal curvature, 1/mm. */
  std::pair<double, double> principalCurvatures(const Eigen::Vector3d& x) const;

  /** A point of the surface near \p p: Newton along the gradient, F = 0 up to rounding; not the closest point. */
  Eigen::Vector3d pulled(const Eigen::Vector3d& p) const;
  /** Closest point of the whole surface, by Newton on the Lagrange conditions, to 1e-9 mm. */
  Eigen::Vector3d closest(const Eigen::Vector3d& p) const;
  /** Distance to the whole surface, positive out of the material. */
  double signedDistance(const Eigen::Vector3d& p) const;

  double area() const;
  /** The outlines in space, the outer first, with their corners. */
  const std::vector<Polyline>& outlines() const;
  /** Straight distance from \p x to the nearest outline; shorter than the distance along the surface by d^3
   * k^2 / 24. */
  double rimDistance(const Eigen::Vector3d& x) const;
  /** Whether the point of the surface at \p x is inside the outline. */
  bool contains(const Eigen::Vector3d& x) const { return region_.contains(chart(x)); }

private:
  struct Rim;
  const Rim& rim() const;
  std::shared_ptr<const Rim> makeRim() const;

  Region region_;
  mutable std::shared_ptr<const Rim> rim_; ///< made on first use
  mutable std::once_flag rim_made_;
};

using SurfacePtr = std::shared_ptr<const AnalyticSurface>;

/** The x-y plane. */
SurfacePtr flat(Region region);
/** Sums of sines on a square of side 1000: relief 449, smallest curvature radius 301 (concave), 396 convex.
 */
SurfacePtr freeform();
/** amplitude sin(kx x + ky y + phase), lengths in mm. */
struct Wave {
  double amplitude, kx, ky, phase;
};
/** z is the sum of the waves over the region. */
SurfacePtr waves(std::vector<Wave> sum, Region region);
/** Waves of 60, 38 and 25 mm on a square from the origin, slopes up to 0.43. */
SurfacePtr landform(double size = 100.0);
/** Upper half of the spheroid of semi-axes a, a, b down to z = 0; chart: parametric latitude from the pole
 * times a. With \p hole_radius the part nearer to the axis is missing. */
SurfacePtr spheroidCap(double a, double b, double hole_radius = 0.0);
/** The inside of a spherical bowl, with the cutter inside. */
SurfacePtr bowl(double radius = 130.0, double opening = 100.0);
/** The outside of a sphere about the origin, over the region of the plane. */
SurfacePtr ball(double radius, Region region);
/** The outside of a cylinder along y, axis through the origin, over the region of the plane. */
SurfacePtr cylinder(double radius, Region region);
/** z = x^2 / (2 rx) + y^2 / (2 ry) over the region; positive radii are concave. */
SurfacePtr quadric(double rx, double ry, Region region);

/** A surface that is flat, slightly wavy, or bent as a whole. */
struct Ground {
  double amplitude = 0.0;                  ///< mm
  double length_x = 45.0, length_y = 50.0; ///< wave lengths over 2 pi, mm
  double bend_x = 0.0, bend_y = 0.0;       ///< 1/mm, positive concave
};
/** z = amplitude sin(x / length_x) cos(y / length_y) + (bend_x x^2 + bend_y y^2) / 2 over the region. */
SurfacePtr ground(const Ground& form, Region region);

/** Oval 150 x 100 (semi-axes), curvature radii 250 concave along x and 200 convex along y. */
SurfacePtr ovalSaddle();
/** Outer circle 150, a hole of radius 45 about (40, 25), gently convex (radius 600). */
SurfacePtr offCentreAnnulus();
/** A kidney 240 wide on a gentle saddle. */
SurfacePtr kidneyPatch();
/** The same bent twice as much, with long thin ends; almost no point sees both ends. */
SurfacePtr boomerangPatch();
/** An L of size 200, limbs 90 wide, on a gently convex surface. */
SurfacePtr ellPatch();

} // namespace pcl_spiral::test
