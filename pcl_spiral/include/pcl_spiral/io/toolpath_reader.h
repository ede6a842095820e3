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
  Polyline tips;                       ///< tool tips, mm; empty if the file has none (.pcd, .ply, .vtp of a ball)
  bool has_contacts = true;            ///< false: a .csv of tips and axes. x y z of the path is then the tip, and normals are zero
};

/** Reads a toolpath from .csv, .pcd, .ply or .vtp, as the writers make it. Each line of a .vtp is a pass. A .csv may also hold only tips
 *  and axes: columns tip_x,tip_y,tip_z,axis_x,axis_y,axis_z or x,y,z,i,j,k, in the order of the path, with a column pass if there are
 *  several: where its number changes, the cutter is lifted. over_gap and lift are read from .csv, .pcd and .ply
 *  where they have them, and are 0 elsewhere. A CSV may contain comment lines (#), as those of earlier versions do. \p origin, mm, is
 *  subtracted from contacts and tips in double precision: for a path in the coordinates of a scan, Scan::shift.
 *  \throw FileError with the line, byte or array that is missing or wrong */
ToolpathFile readToolpath(const std::string& file, const Eigen::Vector3d& origin = Eigen::Vector3d::Zero());

} // namespace pcl_spiral
