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

/** Reads the scan or the mesh, of a scan each region that was chosen, at least one, and sets the shift of the run. \p view_point is
 *  --view-point, if it was given. \throw pcl_spiral::FileError, UsageError */
std::vector<JudgedPart> readParts(const std::string& file, const pcl_spiral::ReadOptions& read, const std::optional<MeshChoice>& mesh,
                                  const std::optional<Eigen::Vector3d>& view_point, const JudgedRegion& asked);
