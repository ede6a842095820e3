// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Readers of toolpath files.
 */
#pragma once

#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/core/polyline.h>

#include <pcl/point_cloud.h>

#include <string>
#include <vector>

namespace pcl_spiral {

/** A toolpath as it was written. */
struct ToolpathFile {
  pcl::PointCloud<ToolpathPoint> path; ///< contacts in travel order, mm
  std::vector<double> feed;            ///< one per point, mm/min; empty if the file has none (.pcd, .ply)
  Polyline tips;                       ///< tool tips, mm; empty if the file has none (all but .csv)
};

/** Reads a toolpath from .csv, .pcd, .ply or .vtp, as the writers make it. over_gap and lift are read from .csv, .pcd and .ply
 *  where they have them, and are 0 elsewhere. A CSV may contain comment lines (#), as those of earlier versions do. \p origin, mm, is
 *  subtracted from contacts and tips in double precision: for a path in the coordinates of a scan, Scan::shift.
 *  \throw FileError with the line, byte or array that is missing or wrong */
ToolpathFile readToolpath(const std::string& file, const Eigen::Vector3d& origin = Eigen::Vector3d::Zero());

} // namespace pcl_spiral
