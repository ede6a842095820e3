// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A picture of the rotary axes along a program.
 */
#pragma once

#include <pcl_spiral/machine/machine_program.h>

#include <string>

namespace pcl_spiral {

/** Angles of both rotary axes and the share of the feed along the length of the path. Marks
 *  show where the tool axis was blended at the pole and where the first axis unwinds. A
 *  PNG of 1600 x 1200. \throw std::runtime_error without a display, FileError if the file
 *  cannot be written, std::invalid_argument for a program without cutting blocks */
void writeRotaryAngles(const std::string& file, const std::string& title, const MachineProgram& program);

} // namespace pcl_spiral
