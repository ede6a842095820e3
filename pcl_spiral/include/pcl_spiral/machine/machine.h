// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The parts of a five-axis machine.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/machine/control_lines.h>

#include <Eigen/Core>

#include <array>
#include <limits>
#include <optional>
#include <string>

namespace pcl_spiral {

/** What a rotary axis turns. */
enum class RotaryMount {
  Table, ///< the workpiece
  Head   ///< the tool
};

/** Acceleration of a linear axis whose limit is not known, mm/s2: that of the setting acceleration of spirals. */
constexpr double usual_linear_acceleration = 2000.0;
/** The same of a rotary axis, radians/s2: 1000 degrees/s2. */
constexpr double usual_rotary_acceleration = 17.453292519943295;

/** Range and speed of one axis: mm and mm/min, or radians and radians/min. */
struct AxisRange {
  double lower = -std::numeric_limits<double>::infinity();       ///< lower limit
  double upper = std::numeric_limits<double>::infinity();        ///< upper limit
  double largest_rate = std::numeric_limits<double>::infinity(); ///< largest speed
  std::optional<double> largest_acceleration;                    ///< mm/s2 or radians/s2; empty: the usual one above
  std::optional<double> largest_jerk;                            ///< mm/s3 or radians/s3; empty: no limit

  /** Whether there is a limit of position. */
  bool finite() const { return lower > -std::numeric_limits<double>::infinity() || upper < std::numeric_limits<double>::infinity(); }
};

/** One rotary axis, as it is when both are at zero. A positive angle turns the table
 *  or head right-handed about the direction. \note If the table turns the other way
 *  (ISO 841 counts the tool against the work), give the opposite direction: 0,0,-1. */
struct RotaryAxis {
  char letter = 'C';                                    ///< A, B or C
  RotaryMount mount = RotaryMount::Table;               ///< what it turns
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ(); ///< any length except 0
  Eigen::Vector3d point = Eigen::Vector3d::Zero();      ///< on the axis, mm; for a table in machine coordinates,
                                                        ///< for a head from the gauge point of the spindle
  AxisRange range;                                      ///< radians and radians/min
  double home = 0.0;                                    ///< programs start as near to this as they can, radians
};

/** Angles of the two rotary axes, radians: first is the axis nearer to the
 *  workpiece. The usual table-table and head-head machines turn the tool about
 *  the workpiece's Z by the first (C), and tilt it by the second (A or B). */
struct RotaryAngles {
  double first = 0.0;  ///< of the axis nearer to the workpiece
  double second = 0.0; ///< of the axis nearer to the tool
};

/** Of the two ways to reach a tool axis, the one with the larger
 *  or the smaller second angle: (A, C) or (-A, C + 180). */
enum class Branch {
  Larger, ///< the larger second angle
  Smaller ///< the smaller second angle
};

/** How the control of this machine plans speeds, where it differs from its family (ControlModel). */
struct ControlPlanning {
  std::optional<int> look_ahead;             ///< moves
  std::optional<bool> rounds_rotary_corners; ///< it rounds corners of moves that turn a rotary axis
};

/** A machine with X, Y and Z, and two rotary axes or none. At zero,
 *  the tool points along +Z from its tip to the spindle. */
struct Machine {
  std::string name;                                    ///< for messages and comments
  std::array<AxisRange, 3> linear;                     ///< of the gauge point, in machine coordinates
  bool three_axes = false;                             ///< there are no rotary axes: the tool stays along +Z
  std::array<RotaryAxis, 2> rotary;                    ///< in order from the workpiece to the tool; tables come before heads
  Eigen::Vector3d work_zero = Eigen::Vector3d::Zero(); ///< zero of the program in machine coordinates, with the rotary axes at zero
  double tool_length = 0.0;                            ///< from the gauge point to the tip, mm
  bool rtcp = true;                     ///< the control keeps the tip in place while the rotary axes turn: programs contain tips
  std::optional<double> retract_z;      ///< machine coordinate of Z that is clear of everything;
                                        ///< used before the first and after the last move
  std::optional<double> path_tolerance; ///< the control may round corners by this, mm; 0: it stops exactly; empty: the program decides
  ShopLines lines;                      ///< of the shop, in every program
  ControlWords words;                   ///< of the control
  ControlPlanning control;              ///< of speeds

  /** The control is given tips and tool axes. */
  bool takesTips() const { return rtcp && !three_axes; }
};

/** LinuxCNC's xyzac-trt-kins with all offsets zero: table C on
 *  trunnion A, no limits, both at up to 30 rev/min, RTCP. */
Machine xyzacTrunnion();

/** Checks the machine: ok, or what is wrong, the value and the remedy. */
Status checkMachine(const Machine& machine);

} // namespace pcl_spiral
