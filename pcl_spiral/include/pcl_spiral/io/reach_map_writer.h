// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Writer of maps of the largest balls.
 */
#pragma once

#include <pcl_spiral/planning/reach_map.h>

#include <Eigen/Core>

#include <string>

namespace pcl_spiral {

/** Writes \p map as x, y, z and radius of each point, mm: .csv, .pcd or .ply. \p origin, mm, is added to the places in double precision:
 *  for the coordinates of a scan, Scan::shift. \throw FileError, also for another extension */
void writeReachMap(const std::string& file, const ReachMap& map, const Eigen::Vector3d& origin = Eigen::Vector3d::Zero());

} // namespace pcl_spiral
