/** \file
 *  How a ridge is made of two measured lines, and what was found of it.
 */
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl_spiral {

/** Which normal the places of a ridge have. */
enum class RidgeNormals {
  True,          ///< across both directions in which the surface runs, dS/du x dS/dv
  InNormalPlane, ///< as published, r x N: across the generator, in the rail's normal plane; off where the frame twists
  Arc            ///< the published short-cut for short generators: out of the circle through start, middle and end
};

/** Settings of a ridge. Lengths in mm. */
struct RidgeSettings {
  Eigen::Vector3d reference = Eigen::Vector3d::UnitZ(); ///< normal of the reference plane; it tells which side is up, too
  double measuring_error = 0.0; ///< standard deviation of a coordinate of the measured points; 0: found from them
  bool flip = false;            ///< the other side is up
};

/** What was found in the measured lines. Lengths in mm, angles in degrees. */
struct RidgeReport {
  std::size_t rail_points = 0, generator_points = 0;
  bool closed = false;            ///< the rail is a ring
  double rail_length = 0.0, generator_length = 0.0;
  double rail_error = 0.0, generator_error = 0.0; ///< standard deviation of a coordinate about the fitted curve
  double rail_direction = 0.0, generator_direction = 0.0; ///< how well the curves' directions are known, rms: as two halves of the points differ
  double meeting = 0.0;           ///< arc length of the rail where it meets the generator
  Eigen::Vector3d meeting_place = Eigen::Vector3d::Zero();
  double meeting_distance = 0.0;  ///< of both lines there
  double chord = 0.0;             ///< from start to end of the generator
  double chord_angle = 0.0;       ///< theta, with the reference plane
  double tilt = 0.0;              ///< of the generator's plane against the rail's normal plane
  double largest_slope = 0.0;     ///< of the rail to the reference plane, and its place
  Eigen::Vector3d steepest_place = Eigen::Vector3d::Zero();
  double slope_factor = 0.0;      ///< the largest; how many times as far an error of the slope turns the chord
  double least_stretch = 1.0;     ///< of the surface along the rail, 1 + omega2 c - omega3 b; 0 where it folds
  std::vector<std::string> warnings;
};

} // namespace pcl_spiral
