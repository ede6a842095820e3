/** \file
 *  Tool axis from surface normals and feed directions. Angles in radians, lengths in the unit of the points.
 */
#pragma once

#include <pcl_spiral/core/polyline.h>

namespace pcl_spiral {

/** How the axis stands to normal and feed. The angle between axis and normal is acos(cos side_tilt cos lead).
 */
struct ToolAxisOptions {
  double side_tilt =
      0.0; ///< right-handed about the feed: positive leans to the right of travel, seen from outside
  double lead = 0.0;     ///< right-handed about the conormal normal x feed: positive leans forward
  double max_rate = 0.0; ///< largest turn of the axis per length of path; 0: no limit
};

/** Axes of a path, one a point, and how far they had to give way. */
struct ToolAxes {
  std::vector<Eigen::Vector3d> axes; ///< unit, from the tip to the shank
  std::vector<double> tilt_share;    ///< share of side_tilt and lead kept at each point, 0 to 1
  double largest_change = 0.0;       ///< between neighbouring points
  double largest_rate = 0.0;         ///< per length of path
  std::size_t limited_points = 0;    ///< points whose tilt was reduced
  double largest_reduction = 0.0;    ///< of the angle between axis and normal
  std::size_t exceeded_moves = 0;    ///< moves on which the normals alone turn faster than max_rate
};

/** Unit feed direction at each point: of the parabola through the point and its distinct neighbours (central
 *  difference at equal spacing), made tangential to \p normals. Repeated points share one direction. Zero
 * where there is none (all points the same, or the path runs along the normal). \throws std::invalid_argument
 * when points and normals differ in number. */
std::vector<Eigen::Vector3d> feedDirections(const Polyline& points,
                                            const std::vector<Eigen::Vector3d>& normals);

/** Axis at one point: the normal turned by \p lead about the conormal, then by \p side_tilt about the feed,
 *  cos lead (cos side_tilt n + sin side_tilt f x n) + sin lead f. \p normal and \p feed unit and
 * perpendicular; without a feed (zero) the axis is the normal. */
Eigen::Vector3d tiltedAxis(const Eigen::Vector3d& normal, const Eigen::Vector3d& feed, double side_tilt,
                           double lead);

/** Axes of a path, their rate limited by blending towards the normal.
 *
 *  Where the feed spins (centre of a spiral, corners) both angles are scaled down by a share w in [0, 1] that
 * is the same seen from either end of the path: each move caps the share of its ends, then a forward and a
 * backward pass limit the change of the share. A move on which the normals alone turn faster than the limit
 * keeps their rate; it is counted. Time is linear in the number of points. \param normals unit, one a point.
 *  \throws std::invalid_argument when points and normals differ in number, an angle is not under 90 degrees,
 * or the rate is negative or not a number. */
ToolAxes toolAxes(const Polyline& points, const std::vector<Eigen::Vector3d>& normals,
                  const ToolAxisOptions& options);

} // namespace pcl_spiral
