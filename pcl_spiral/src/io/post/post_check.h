// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What a language can write.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/io/program_writer.h>

#include <string>

namespace pcl_spiral {

/** Why \p dialect cannot say a program of \p machine with the settings of \p header, whatever its blocks; empty if it can. */
Diagnostic faultOfSettings(Dialect dialect, const Machine& machine, const ProgramHeader& header);

/** \throw FileError for what the writer of \p dialect refuses, see writeProgram */
void requireProgram(const std::string& file, Dialect dialect, const MachineProgram& program, const ProgramHeader& header);

} // namespace pcl_spiral
