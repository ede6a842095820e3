/** \file
 *  What a five-axis machine is made of.
 */
#pragma once

#include <pcl_spiral/common/status.h>

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

/** How far and how fast one axis goes: mm and mm/min, or radians and radians/min. */
struct AxisRange {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  double largest_rate = std::numeric_limits<double>::infinity();

  bool
  finite() const
  {
    return lower > -std::numeric_limits<double>::infinity() ||
           upper < std::numeric_limits<double>::infinity();
  }
};

/** One rotary axis as it stands when both are at zero. A positive angle turns the table or head right-handed
 * about the direction. \note Machines whose table turns the other way (ISO 841 counts the tool against the
 * work) have the opposite direction: 0,0,-1. */
struct RotaryAxis {
  char letter = 'C'; ///< A, B or C
  RotaryMount mount = RotaryMount::Table;
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
  Eigen::Vector3d point = Eigen::Vector3d::Zero(); ///< on the axis, mm; table: in machine coordinates, head:
                                                   ///< from the spindle's gauge point
  AxisRange range;
  double home = 0.0; ///< programs start as near to this as they can, radians
};

/** A machine with X, Y and Z and two rotary axes. At zero the tool points along +Z from its tip to the
 * spindle. */
struct Machine {
  std::string name;
  std::array<AxisRange, 3> linear; ///< of the gauge point, machine coordinates
  std::array<RotaryAxis, 2>
      rotary; ///< in the order from the workpiece to the tool; tables stand before heads
  Eigen::Vector3d work_zero =
      Eigen::Vector3d::Zero(); ///< the program's zero in machine coordinates, rotaries at zero
  double tool_length = 0.0;    ///< from the gauge point to the tip, mm
  bool rtcp = true; ///< the control keeps the tip in place while the rotaries turn: programs hold tips
  std::optional<double> retract_z; ///< machine coordinate of Z that is clear of everything, before the first
                                   ///< and after the last move
  double path_tolerance = 0.01;    ///< that the control may round corners by (G64 P), mm
};

/** LinuxCNC's xyzac-trt-kins with nothing off zero: table C on trunnion A, no limits, both at up to 30
 * rev/min, RTCP. */
Machine xyzacTrunnion();

/** Whether the machine can be: what is wrong, the value and the remedy otherwise. */
Status checkMachine(const Machine& machine);

} // namespace pcl_spiral
