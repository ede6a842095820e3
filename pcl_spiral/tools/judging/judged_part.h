// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The part that paths are judged by.
 */
#pragma once

#include "judge_options.h"

#include <string>
#include <vector>

struct JudgedPart {
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr cloud; ///< the scan; null: there is a mesh
  ScanSide side;                                  ///< of the scan
  pcl_spiral::SurfaceMesh::ConstPtr mesh;
  std::vector<std::string> warnings; ///< from reading
};

/** Reads the scan or the mesh and sets the shift of the run. \p side holds --view-point, if it was given. \throw pcl_spiral::FileError */
JudgedPart readPart(const std::string& file, const pcl_spiral::ReadOptions& read, const std::optional<MeshChoice>& mesh,
                    const ScanSide& side);
