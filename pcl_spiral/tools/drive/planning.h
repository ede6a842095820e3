// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  From a scan to passes of cutter locations.
 */
#pragma once

#include "job.h"
#include "passes/pass_result.h"

#include <pcl_spiral/drive/drive_settings.h>
#include <pcl_spiral/surface/surface.h>

#include <string>
#include <vector>

/** The passes of one of several regions. */
struct RegionPasses {
  std::string name;
  std::size_t passes = 0, locations = 0;
};

/** The result of a run. */
struct Result : PassResult {
  pcl_spiral::DriveReport drive;
  std::string region;                    ///< its name, if it is one of several
  pcl_spiral::Surface::ConstPtr surface; ///< of the part; null for a mesh, and for points that form none
  std::vector<RegionPasses> regions;     ///< if there are several: in the order of their passes
};

/** Reads the scan or the mesh, makes the drive path, finds the cutter locations. \throw UsageError, pcl_spiral::FileError, Cancelled */
Result plan(const Job& job);
