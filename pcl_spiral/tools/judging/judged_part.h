// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The part that paths are judged by.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>

#include "judge_options.h"
#include "raw_scan_option.h"
#include "terminal/region_choice.h"

#include <string>
#include <vector>

struct JudgedPart {
  std::string region;                             ///< its name; empty: it is the only one
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr cloud; ///< the scan; null: there is a mesh
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr whole; ///< the scan with what the choice of the part left out
  ScanSide side;                                  ///< of the scan
  pcl_spiral::SurfaceMesh::ConstPtr mesh;
  pcl_spiral::ChosenPart chosen;    ///< of the scan
  pcl_spiral::Diagnostics warnings; ///< from reading
};

/** Which points of a scan are judged, in how many regions, and by what cutter they are cut. */
struct JudgedRegion {
  PartOptions choice;
  RegionChoice regions = {};
  pcl_spiral::PartTool tool = {};
  bool flip_normals = false;
  unsigned int threads = 0;
};

/** Reads the scan or the mesh, of a scan each region that was chosen, at least one, and sets the shift of the run. \p side holds
 *  --view-point, if it was given. \throw pcl_spiral::FileError, UsageError */
std::vector<JudgedPart> readParts(const std::string& file, const pcl_spiral::ReadOptions& read, const std::optional<MeshChoice>& mesh,
                                  const ScanSide& side, const JudgedRegion& asked);

/** How far the tool axis leans from the normals of \p path, degrees: all but one point in a hundred lean less. */
double leanOf(const pcl::PointCloud<pcl_spiral::ToolpathPoint>& path);

/** What is wrong where the path cuts into the \p raw scan, deeper than \p allowed and the noise of its means. Empty: nothing. */
pcl_spiral::Diagnostic faultInRaw(const pcl_spiral::RawScanFigures& raw, const pcl::PointCloud<pcl_spiral::ToolpathPoint>::ConstPtr& path,
                                  const JudgeSettings& settings, double allowed);

/** What is wrong where the path meets the limits of the part: its cutter enters a keep-out, or cuts into what stands there, into the scan
 *  beside, into the parts that \p reference leaves out, or into a cluster that stands on it. Empty: nothing. \p settings: cutter and tips.
 *  \p allowed: depth of a cut that counts as none, mm. Adds to \p warnings where only false echoes beside the part are met. */
pcl_spiral::Diagnostics faultsBeside(const JudgedPart& part, const pcl_spiral::Surface& reference,
                                     const pcl::PointCloud<pcl_spiral::ToolpathPoint>::ConstPtr& path, const JudgeSettings& settings,
                                     double allowed, pcl_spiral::Diagnostics& warnings);
