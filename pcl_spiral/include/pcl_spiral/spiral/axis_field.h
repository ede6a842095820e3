// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Tool axes that a machine can follow.
 */
#pragma once

#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/common/status.h>

#include <pcl/point_cloud.h>

#include <cstddef>

namespace pcl_spiral {

/** Smooths the tool axes of a path along its length and limits how fast they turn.
 *
 *  Short changes along the path, such as noise of the normals or a dent in a turn, are smoothed away. Then every move keeps
 *  the axis rate. Where a tilt turns faster (the pole of a dome), the axis passes close to the normal without a spin or a jump.
 *  The result is the same from both ends of the path. The centre of the ball does not depend on the axis; only the tip does.
 *  Source of the smoothing spline: Reinsch 1967. */
class AxisField {
public:
  using Path = pcl::PointCloud<ToolpathPoint>; ///< A toolpath.

  /** Path in travel order, with the wanted axis at every point. If it has surface normals too, axes are checked against
   *  them. */
  void setInputPath(const Path::ConstPtr& path) { path_ = path; }
  Path::ConstPtr getInputPath() const { return path_; } ///< The value of setInputPath.

  /** Smoothing length, mm: shorter changes are smoothed away; 50 by default, 0 for none. A wave of length 2 pi l keeps the
   *  share 1 / (1 + (length / l)^4). */
  void setAxisSmoothing(double length) { smoothing_length_ = length; }
  /** \deprecated Renamed setAxisSmoothing. */
  [[deprecated("use setAxisSmoothing")]] void setSmoothingLength(double length) { setAxisSmoothing(length); }
  double getAxisSmoothing() const { return smoothing_length_; } ///< The value of setAxisSmoothing.

  /** How far smoothing may move the axis from the wanted one, degrees, in the mean over its length; 2 by default. Where it would
   *  move it farther, it smooths less. The axis rate has priority: points with a larger deviation are counted. */
  void setAxisDeviation(double degrees) { max_deviation_ = degrees; }
  /** \deprecated Renamed setAxisDeviation. */
  [[deprecated("use setAxisDeviation")]] void setMaxDeviation(double degrees) { setAxisDeviation(degrees); }
  double getAxisDeviation() const { return max_deviation_; } ///< The value of setAxisDeviation.

  /** Largest turn of the axis, degrees per mm of path; 10 by default, 0 for no limit. */
  void setMaxAxisRate(double degrees_per_mm) { max_axis_rate_ = degrees_per_mm; }
  double getMaxAxisRate() const { return max_axis_rate_; } ///< The value of setMaxAxisRate.

  /** Copy the path and set its axes. \p output may be the input cloud. It is empty on failure: no path, a point or
   *  axis that is not finite, an axis of zero length, a setting out of range, or an axis that the rate limit would
   *  tilt into the surface. */
  void compute(Path& output);

  const Status& getStatus() const { return status_; } ///< result of the last run

  /** Largest turn of the axis between neighbouring points of the last compute, degrees. */
  double getLargestAxisChange() const { return largest_change_; }
  /** Largest turn of the axis per mm of path, degrees. */
  double getLargestAxisRate() const { return largest_rate_; }
  /** Largest angle between an axis and the wanted one, degrees. */
  double getLargestDeviation() const { return largest_deviation_; }
  /** Number of points with an angle above the largest deviation. */
  std::size_t getDeviatingPoints() const { return deviating_points_; }
  /** Largest angle between an axis and the surface normal, degrees; 0 for a path without normals. */
  double getLargestLean() const { return largest_lean_; }

private:
  Status check() const;
  Status smooth(Path& output);

  Path::ConstPtr path_;
  double smoothing_length_ = 50.0;
  double max_deviation_ = 2.0;
  double max_axis_rate_ = 10.0;
  Status status_;
  double largest_change_ = 0.0;
  double largest_rate_ = 0.0;
  double largest_deviation_ = 0.0;
  double largest_lean_ = 0.0;
  std::size_t deviating_points_ = 0;
};

} // namespace pcl_spiral
