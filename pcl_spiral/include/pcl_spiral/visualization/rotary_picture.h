/** \file
 *  A picture of the rotary axes along a program.
 */
#pragma once

#include <pcl_spiral/machine/machine_program.h>

#include <string>

namespace pcl_spiral {

/** Angles of both rotary axes and the share of the feed over the length of the path, with the places where
 * the tool axis was blended at the pole and where the first axis unwinds; a PNG of 1600 x 1200. \throw
 * std::runtime_error without a display, FileError where the file cannot be written, std::invalid_argument for
 * a program that cuts nothing */
void writeRotaryAngles(const std::string& file, const std::string& title, const MachineProgram& program);

} // namespace pcl_spiral
