// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Programs of one language each.
 */
#pragma once

#include <pcl_spiral/io/program_reader.h>

#include <string>
#include <string_view>

namespace pcl_spiral {

/** LinuxCNC, Fanuc and Siemens. \throw FileError as readProgram does */
ProgramFile readGCode(const std::string& file, std::string_view text, const Machine& machine, Dialect dialect);

/** Heidenhain Klartext. \throw FileError as readProgram does */
ProgramFile readKlartext(const std::string& file, std::string_view text, const Machine& machine);

/** APT. The axis moves along arcs if \p has_machine is false: \p machine then only stands for one that reaches every axis. \throw FileError
 *  as readProgram does */
ProgramFile readAPT(const std::string& file, std::string_view text, const Machine& machine, bool has_machine);

} // namespace pcl_spiral
