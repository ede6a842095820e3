// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A ridge: the surface that a generator sweeps along a rail.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/core/impl/ridge_frame.h>
#include <pcl_spiral/ridge/impl/measured_line.h>
#include <pcl_spiral/ridge/impl/ridge_settings.h>
#include <pcl_spiral/ridge/impl/smooth_line.h>

#include <memory>
#include <optional>

namespace pcl_spiral {

/** The surface S(u, v) = L(u) + a(v) m1 + b(v) m2 + c(v) m3: rail L, frame m1, m2, m3 of equation (1) (\see
 *  ridgeFrame), local coordinates a, b, c of the measured generator. u and v are the arc lengths of both
 *  lines in mm. Source: the feature-line method for ridges in 3-D laser surface hardening (China Mechanical
 *  Engineering), equations (1) to (3); a is small and is kept. Immutable; any number of threads may use it.
 *
 *  The rail runs from the end nearer to the generator. A ring runs counter-clockwise about the reference normal, from the place
 *  where it meets the generator. The generator runs so that up, m3, is on the side of the reference normal. So points may come
 *  in any order. Exception: if the generator is exactly at the middle of the rail, the direction of the rail is not fixed. */
class RidgeSurface {
public:
  using ConstPtr = std::shared_ptr<const RidgeSurface>;

  /** Makes the surface from the points of both lines. \p result is null on failure.
   *
   *  InvalidInput, with place and value: what orderLine refuses; a corner of the rail of more than 30 degrees;
   *  start and end of the generator nearer than a twentieth of its length; the generator far from the rail, or
   *  beyond its ends; its plane tilted by more than 15 degrees against the normal plane of the rail; the rail
   *  too steep for the angle of the chord, or along the reference normal, where the frame would turn over; a
   *  fold of the surface. InvalidArgument: a reference normal without direction, a measuring error below 0. */
  static Status make(const Polyline& rail, const Polyline& generator, const RidgeSettings& settings, ConstPtr& result);

  const RidgeSettings& settings() const { return settings_; }
  const RidgeReport& report() const { return report_; }
  const SmoothLine& rail() const { return rail_; }
  /** In local coordinates. */
  const SmoothLine& generator() const { return generator_; }
  const RidgeChord& chord() const { return chord_; }

  RidgeFrame frame(double u) const;
  Eigen::Vector3d position(double u, double v) const;
  /** Unit, up. */
  Eigen::Vector3d normal(double u, double v, RidgeNormals normals = RidgeNormals::True) const;
  /** Derivatives of the position by u and by v. */
  Eigen::Vector3d alongRail(double u, double v) const;
  Eigen::Vector3d alongGenerator(double u, double v) const;

private:
  Status fit(const Polyline& rail, const Polyline& generator);
  Status place(const MeasuredLine& generator, bool may_turn, bool& turned);
  void warnOfMeeting(const MeasuredLine& rail, const MeasuredLine& generator);
  void warnOfDirections();
  Status checkRail();
  void warnOfSlope(const Eigen::Vector3d& sensitive);
  Status checkFolds();

  RidgeSettings settings_;
  RidgeReport report_;
  SmoothLine rail_, generator_;
  RidgeChord chord_;
  Eigen::Vector3d arc_centre_ = Eigen::Vector3d::Zero(); ///< of the circle through start, middle and end, in local coordinates
};

} // namespace pcl_spiral
