// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Where the axes of a program come nearest to their limits.
 */
#pragma once

#include <pcl_spiral/machine/machine_program.h>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** An axis at its smallest or largest value. mm in machine coordinates, or radians. */
struct AxisExtreme {
  char letter = 'X';     ///< of the axis
  bool rotary = false;   ///< the value is an angle
  bool largest = false;  ///< otherwise the smallest
  std::size_t block = 0; ///< at whose end
  double value = 0.0;
  double limit = 0.0; ///< on this side; infinite: there is none
};

/** Both of X, Y and Z of the gauge point and of each rotary axis; none of a program without blocks. */
std::vector<AxisExtreme> axisExtremes(const MachineProgram& program);

} // namespace pcl_spiral
