// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The program of a machine, as a user describes it.
 */
#pragma once

#include <pcl_spiral/io/program_writer.h>
#include <pcl_spiral/machine/machine_program_generator.h>

#include <string>

struct ProgramJob {
  std::string machine_file;
  pcl_spiral::Dialect dialect = pcl_spiral::Dialect::LinuxCNC; ///< of .nc
  pcl_spiral::ProgramSettings settings;                        ///< feed and ball radius are the path's
  pcl_spiral::ProgramHeader header;
  bool accept_collisions = false; ///< of what holds the cutter, and of the tool off its path
};
