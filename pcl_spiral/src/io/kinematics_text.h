// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The words by which programs name the kinematics that they were made for.
 */
#pragma once

#include <pcl_spiral/machine/machine.h>

#include <string>

namespace pcl_spiral {

constexpr const char* offset_opening = "work offset ";           ///< what follows it in a comment is the work offset of the program
constexpr const char* kinematics_opening = "from work to tool "; ///< kinematicsText begins with it

/** "from work to tool table C table A, X Y Z of the tool tip" */
inline std::string
kinematicsText(const Machine& machine)
{
  if (machine.three_axes)
    return std::string(kinematics_opening) + "no rotary axes, X Y Z of the machine";
  const auto word = [](const RotaryAxis& axis) { return std::string(axis.mount == RotaryMount::Table ? "table " : "head ") + axis.letter; };
  return kinematics_opening + word(machine.rotary[0]) + " " + word(machine.rotary[1]) +
         (machine.rtcp ? ", X Y Z of the tool tip" : ", X Y Z of the machine");
}

} // namespace pcl_spiral
