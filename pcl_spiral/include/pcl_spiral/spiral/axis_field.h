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
 *  What is short along the path, as noise of normals or a dent in a turn, is smoothed away; then every move keeps the
 *  axis rate. Where a tilt spins faster (the pole of a dome) the axis passes through near the normal, without a spin or
 *  a jump, the same from either end of the path. The ball's centre does not depend on the axis; only the tip does. The
 *  maths is smoothAxes in core/axis_field.h. */
class AxisField {
public:
  using Path = pcl::PointCloud<ToolpathPoint>;

  /** Path in travel order, with the wanted axis at every point; where it has surface normals too, axes are held against
   *  them. */
  void setInputPath(const Path::ConstPtr& path) { path_ = path; }
  Path::ConstPtr getInputPath() const { return path_; }

  /** What is shorter along the path is smoothed away, mm; 50 by default, 0 for none. A wave of length 2 pi l keeps the
   *  share 1 / (1 + (length / l)^4). */
  void setSmoothingLength(double length) { smoothing_length_ = length; }
  double getSmoothingLength() const { return smoothing_length_; }

  /** How far smoothing may lead from the wanted axes, degrees, in the mean over its length; 2 by default. Where it would
   *  lead farther it smooths over less. The axis rate comes first: what leaves the wanted axis farther is counted. */
  void setMaxDeviation(double degrees) { max_deviation_ = degrees; }
  double getMaxDeviation() const { return max_deviation_; }

  /** Largest turn of the axis, degrees per mm of path; 10 by default, 0 for no limit. */
  void setMaxAxisRate(double degrees_per_mm) { max_axis_rate_ = degrees_per_mm; }
  double getMaxAxisRate() const { return max_axis_rate_; }

  /** Copy the path and set its axes. \p output may be the input's cloud; it is empty on failure: no path, a point or
   *  axis that is not finite, an axis of no length, a setting out of range, or an axis that would come to lie in the
   *  surface so as not to turn faster. */
  void compute(Path& output);

  const Status& getStatus() const { return status_; }

  /** Largest turn of the axis between neighbouring points of the last compute, degrees. */
  double getLargestAxisChange() const { return largest_change_; }
  /** Largest turn of the axis per mm of path, degrees. */
  double getLargestAxisRate() const { return largest_rate_; }
  /** Largest angle between an axis and the one wanted, degrees. */
  double getLargestDeviation() const { return largest_deviation_; }
  /** Points at which it is above the largest deviation. */
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
