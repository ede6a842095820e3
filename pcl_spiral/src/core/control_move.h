// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A straight move as a control plans it.
 */
#pragma once

#include <Eigen/Core>

#include <cstddef>

namespace pcl_spiral {

using AxisValues = Eigen::Matrix<double, 5, 1>; ///< X Y Z and the two rotary axes: mm and radians

/** What the axes may do: mm or radians, and s. */
struct AxisDynamics {
  AxisValues velocity, acceleration, jerk;
};

/** A straight move. */
struct ControlMove {
  AxisValues way = AxisValues::Zero(); ///< of each axis
  double length = 0.0;                 ///< of X Y Z, mm; where they stand, of the rotary axes, radians
  double speed = 0.0;                  ///< asked for or that the axes allow, per s
  double acceleration = 0.0;           ///< that the axes allow
  double jerk = 0.0;                   ///< that the axes allow
  bool rapid = false;
  bool turns = false;    ///< a rotary axis turns
  std::size_t block = 0; ///< of the program
};

/** The move by \p way, whose length is \p length, at most at \p speed, as the axes allow. */
ControlMove controlMove(const AxisValues& way, double length, double speed, const AxisDynamics& axes);

} // namespace pcl_spiral
