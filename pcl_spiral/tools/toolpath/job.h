// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What one run of pcl_spiral_toolpath is asked to do.
 */
#pragma once

#include "program/program_job.h"

#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/spiral/spiral_settings.h>

#include <set>
#include <string>
#include <vector>

/** A run as the user described it. */
struct Job {
  std::set<std::string> given; ///< names of the options that were set, here or in a job file
  std::string command;         ///< the call as typed
  std::string scan;
  std::string config_file;
  std::vector<std::string> outputs;
  pcl_spiral::ReadOptions read;
  pcl_spiral::SpiralSettings settings;
  ProgramJob program;
  bool mesh = false;           ///< the scan is a mesh, and its faces count
  double sample_spacing = 0.0; ///< of the points the mesh is sampled at, mm; 0: found
  bool verify = false;         ///< judge the path by the scan or the mesh
  bool verbose = false;
  bool quiet = false;
  bool help = false;
  bool version = false;
};
