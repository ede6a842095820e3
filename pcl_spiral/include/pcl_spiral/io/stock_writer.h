// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Writers of the surface after cutting.
 */
#pragma once

#include <pcl_spiral/verify/stock_mesh.h>

#include <Eigen/Core>

#include <string>

namespace pcl_spiral {

/** Writes \p mesh as binary .ply with the vertex property stock, mm, or as binary .stl. \p origin, mm, is added to the places in a .ply in
 *  double precision: for the coordinates of a scan, Scan::shift. A .stl, which is in single precision, keeps the shifted coordinates and
 *  names the origin in its header. \throw FileError, also for a .stl without triangles */
void writeStock(const std::string& file, const StockMesh& mesh, const Eigen::Vector3d& origin = Eigen::Vector3d::Zero());

} // namespace pcl_spiral
