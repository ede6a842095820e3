/** \file
 *  Tool axes along a toolpath.
 */
#pragma once

#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/common/status.h>

#include <pcl/point_cloud.h>

#include <cstddef>

namespace pcl_spiral {

/** Sets the tool axis of every point of a path: its normal, tilted sideways about the feed direction and led
 * about the conormal, with a limit on how fast it turns.
 *
 *  Where the feed direction spins (centre of a spiral, corners) the tilt is blended towards the normal, the
 * same seen from either end of the path. The ball's centre does not depend on the axis; only the tip does.
 * The maths is toolAxes in core/tool_axis.h. */
class ToolAxis {
public:
  using Path = pcl::PointCloud<ToolpathPoint>;

  /** Path in travel order, with the unit surface normal at every point. */
  void
  setInputPath(const Path::ConstPtr& path)
  {
    path_ = path;
  }
  Path::ConstPtr
  getInputPath() const
  {
    return path_;
  }

  /** Side tilt about the feed direction, degrees, within +-89; 15 by default. Positive leans to the right of
   * travel, seen from outside the material. */
  void
  setTiltAngle(double degrees)
  {
    tilt_angle_ = degrees;
  }
  double
  getTiltAngle() const
  {
    return tilt_angle_;
  }

  /** Lead about the conormal, degrees, within +-89; 0 by default. Positive leans forward. */
  void
  setLeadAngle(double degrees)
  {
    lead_angle_ = degrees;
  }
  double
  getLeadAngle() const
  {
    return lead_angle_;
  }

  /** Largest turn of the axis, degrees per mm of path; 10 by default, 0 for no limit. */
  void
  setMaxAxisRate(double degrees_per_mm)
  {
    max_axis_rate_ = degrees_per_mm;
  }
  double
  getMaxAxisRate() const
  {
    return max_axis_rate_;
  }

  /** Copy the path and set its axes. \p output may be the input's cloud; it is empty on failure: no path,
   * fewer than two points, a point or normal that is not finite, a normal of no length, or a setting out of
   * range. */
  void compute(Path& output);

  const Status&
  getStatus() const
  {
    return status_;
  }

  /** Largest turn of the axis between neighbouring points of the last compute, degrees. */
  double
  getLargestAxisChange() const
  {
    return largest_change_;
  }
  /** Largest turn of the axis per mm of path of the last compute, degrees. */
  double
  getLargestAxisRate() const
  {
    return largest_rate_;
  }
  /** Points whose tilt was reduced by the rate limit. */
  std::size_t
  getLimitedPoints() const
  {
    return limited_points_;
  }
  /** Largest reduction of the angle between axis and normal at any of them, degrees. */
  double
  getLargestTiltReduction() const
  {
    return largest_reduction_;
  }
  /** Moves on which the surface normal alone turns faster than the limit: the path is too sharp for it there.
   */
  std::size_t
  getExceededMoves() const
  {
    return exceeded_moves_;
  }

private:
  Status check() const;

  Path::ConstPtr path_;
  double tilt_angle_ = 15.0;
  double lead_angle_ = 0.0;
  double max_axis_rate_ = 10.0;
  Status status_;
  double largest_change_ = 0.0;
  double largest_rate_ = 0.0;
  double largest_reduction_ = 0.0;
  std::size_t limited_points_ = 0;
  std::size_t exceeded_moves_ = 0;
};

} // namespace pcl_spiral
