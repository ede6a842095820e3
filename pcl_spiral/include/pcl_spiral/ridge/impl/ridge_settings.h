// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  How a ridge is made from two measured lines, and what was found of it.
 */
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl_spiral {

/** Which normal the places of a ridge have. */
enum class RidgeNormals {
  True,          ///< normal to both directions of the surface, dS/du x dS/dv
  InNormalPlane, ///< as published, r x N: across the generator, in the normal plane of the rail; wrong where the frame twists
  Arc            ///< the published short-cut for short generators: from the circle through start, middle and end
};

/** Settings of a ridge. Lengths in mm. */
struct RidgeSettings {
  Eigen::Vector3d reference = Eigen::Vector3d::UnitZ(); ///< normal of the reference plane; it also defines which side is up
  double measuring_error = 0.0;                         ///< standard deviation of a coordinate of the measured points; 0: found from them
  bool flip = false;                                    ///< the other side is up
};

/** What was found in the measured lines. Lengths in mm, angles in degrees. */
struct RidgeReport {
  std::size_t rail_points = 0, generator_points = 0;
  bool closed = false; ///< the rail is a ring
  double rail_length = 0.0, generator_length = 0.0;
  double rail_error = 0.0, generator_error = 0.0;         ///< standard deviation of a coordinate about the fitted curve
  double rail_direction = 0.0, generator_direction = 0.0; ///< error of the curves' directions, rms: from two halves of the points
  double meeting = 0.0;                                   ///< arc length of the rail where it meets the generator
  Eigen::Vector3d meeting_place = Eigen::Vector3d::Zero();
  double meeting_distance = 0.0; ///< between both lines there
  double chord = 0.0;            ///< from start to end of the generator
  double chord_angle = 0.0;      ///< theta, with the reference plane
  double tilt = 0.0;             ///< angle between the plane of the generator and the normal plane of the rail
  double largest_slope = 0.0;    ///< of the rail against the reference plane, and its place
  Eigen::Vector3d steepest_place = Eigen::Vector3d::Zero();
  double slope_factor = 0.0;  ///< the largest: an error of the slope turns the chord by this many times as much
  double least_stretch = 1.0; ///< of the surface along the rail, 1 + omega2 c - omega3 b; 0 where it folds
  std::vector<std::string> warnings;
};

} // namespace pcl_spiral
