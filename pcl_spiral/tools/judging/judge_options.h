// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Options for scan and cutter, shared by the programs that judge paths.
 */
#pragma once

#include "terminal/program_run.h"
#include "terminal/region_choice.h"
#include "terminal/scan_places.h"

#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/mesh/surface_mesh.h>
#include <pcl_spiral/planning/impl/path_judging.h>

#include <string>
#include <vector>

/** What judging programs are told: what is judged, by what, and the cutter. */
struct JudgeOptions : ProgramRun {
  std::vector<std::string> files; ///< the scan or mesh, then the paths
  pcl_spiral::ReadOptions read = readFindingOrigin();
  bool mesh = false;                      ///< the first file is a mesh
  pcl_spiral::MeshSettings mesh_settings; ///< of it; its side is also that of a scan
  PartOptions part;                       ///< of a scan
  RegionChoice regions;                   ///< of a scan
  pcl_spiral::JudgeSettings settings;     ///< cutter with radius 0: not given
};

/** --file with \p files_help, how it is read, the part and the mesh. */
OptionGroup judgedFiles(JudgeOptions& job, const std::string& files_help);

/** The cutter, with \p radius_help of --tool-radius, and the finish. */
OptionGroup judgedCutter(JudgeOptions& job, const std::string& radius_help);

/** Completes the cutter, and checks that the options fit each other. \throw UsageError */
void completeJudging(JudgeOptions& job);

/** \throw UsageError with \p message unless \p holds */
void require(bool holds, const pcl_spiral::Diagnostic& message);
