// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What a language can write.
 */
#pragma once

#include <pcl_spiral/io/program_writer.h>

#include <string>

namespace pcl_spiral {

/** \throw FileError for what the writer of \p dialect refuses, see writeProgram */
void requireProgram(const std::string& file, Dialect dialect, const MachineProgram& program, const ProgramHeader& header);

} // namespace pcl_spiral
