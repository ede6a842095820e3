// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The user's settings for a machine program.
 */
#pragma once

#include <pcl_spiral/io/path_exchange.h>
#include <pcl_spiral/io/program_writer.h>
#include <pcl_spiral/machine/machine_program_generator.h>

#include <optional>
#include <string>

struct ProgramJob {
  std::string machine_file;
  pcl_spiral::Dialect dialect = pcl_spiral::Dialect::LinuxCNC; ///< of .nc
  pcl_spiral::ProgramSettings settings;                        ///< feed and ball radius come from the path
  pcl_spiral::ProgramHeader header;                            ///< title, notes and smoothing come from the path
  std::optional<double> smoothing;                             ///< mm; none: the chord error
  pcl_spiral::RobotZ robot_z = pcl_spiral::RobotZ::Axis;       ///< of .yaml
  bool gains = false;                                          ///< plan again to tell what other settings would gain
  bool accept_collisions = false;                              ///< of shank and holder, and of the tool on its leads
};
