// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Tool axes along a toolpath.
 */
#pragma once

#include <pcl_spiral/spiral/axis_field.h>

#include <cstddef>

namespace pcl_spiral {

/** Sets the tool axis of every point of a path: the normal, tilted sideways about the feed direction and forwards about the
 *  conormal, then smoothed along the path and limited in rate by AxisField. */
class ToolAxis {
public:
  using Path = pcl::PointCloud<ToolpathPoint>; ///< A toolpath.

  /** Path in travel order, with the unit surface normal at every point. */
  void setInputPath(const Path::ConstPtr& path) { path_ = path; }
  Path::ConstPtr getInputPath() const { return path_; } ///< The value of setInputPath.

  /** Side tilt about the feed direction, degrees, within +-89; 15 by default. Positive leans to the right of travel, seen
   *  from outside the material. */
  void setTiltAngle(double degrees) { tilt_angle_ = degrees; }
  double getTiltAngle() const { return tilt_angle_; } ///< The value of setTiltAngle.

  /** Lead about the conormal, degrees, within +-89; 0 by default. Positive leans forward. */
  void setLeadAngle(double degrees) { lead_angle_ = degrees; }
  double getLeadAngle() const { return lead_angle_; } ///< The value of setLeadAngle.

  /** Smoothing length, mm: shorter changes along the path are smoothed away; 50 by default, 0 for none. See AxisField. */
  void setAxisSmoothing(double length) { field_.setAxisSmoothing(length); }
  /** \deprecated Renamed setAxisSmoothing. */
  [[deprecated("use setAxisSmoothing")]] void setSmoothingLength(double length) { setAxisSmoothing(length); }
  double getAxisSmoothing() const { return field_.getAxisSmoothing(); } ///< The value of setAxisSmoothing.

  /** How far smoothing may move the axis from the requested tilt, degrees; 2 by default. See AxisField. */
  void setAxisDeviation(double degrees) { field_.setAxisDeviation(degrees); }
  /** \deprecated Renamed setAxisDeviation. */
  [[deprecated("use setAxisDeviation")]] void setMaxDeviation(double degrees) { setAxisDeviation(degrees); }
  double getAxisDeviation() const { return field_.getAxisDeviation(); } ///< The value of setAxisDeviation.

  /** Largest turn of the axis, degrees per mm of path; 10 by default, 0 for no limit. */
  void setMaxAxisRate(double degrees_per_mm) { field_.setMaxAxisRate(degrees_per_mm); }
  double getMaxAxisRate() const { return field_.getMaxAxisRate(); } ///< The value of setMaxAxisRate.

  /** Copy the path and set its axes. \p output may be the input cloud. It is empty on failure: no path, fewer than two
   *  points, a point or normal that is not finite, a normal of zero length, a setting out of range, or an axis that the rate
   *  limit would tilt into the surface. */
  void compute(Path& output);

  const Status& getStatus() const { return status_; } ///< result of the last run

  /** Results of smoothing and rate limit in the last compute: changes, rates, deviations and leans of the axis. */
  const AxisField& getField() const { return field_; }
  /** Number of moves on which the surface normal itself turns faster than the axis rate: the path is too sharp there to
   *  keep the tilt. */
  std::size_t getExceededMoves() const { return exceeded_moves_; }

private:
  Status check() const;
  Path::Ptr wantedAxes();

  Path::ConstPtr path_;
  AxisField field_;
  double tilt_angle_ = 15.0;
  double lead_angle_ = 0.0;
  Status status_;
  std::size_t exceeded_moves_ = 0;
};

} // namespace pcl_spiral
