// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Writers of what a path leaves, for programs that show scenes and time series.
 */
#pragma once

#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/verify/stock_mesh.h>

#include <pcl/point_cloud.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace pcl_spiral {

/** The contents of a scene. Lengths in mm. */
struct CutScene {
  StockMesh stock;                                 ///< stockMesh of what the path leaves
  pcl::PointCloud<ToolpathPoint>::ConstPtr path;   ///< contacts
  double limit = 0.0;                              ///< RemovalReport::limit: stock above it has a colour of its own
  double gouge = 0.0;                              ///< so have gouges deeper than this
  Eigen::Vector3d shift = Eigen::Vector3d::Zero(); ///< Scan::shift: what was taken from the places
};

/** Writes \p scene as glTF 2.0: .gltf, with its data inside, or .glb. Three nodes: "part", the surface without stock; "path", a line for
 *  each pass; "stock", the surface with its stock, coloured by it, with the height in mm as vertex attribute _STOCK. Lengths are in metres
 *  and y is up, as glTF asks. Places stay shifted, as they are in single precision: to be added to them is asset.extras.shift_mm, x y z of
 *  the scan in mm, which is absent where nothing was shifted. Passes of one point are left out. The same scene gives the same bytes. Not
 *  by VTK's exporter: that of Debian 12 needs a window and writes no .glb. \throw FileError, also for a surface without triangles or a path
 *  without moves */
void writeScene(const std::string& file, const CutScene& scene);

/** One moment of a time series. */
struct CutMoment {
  double seconds = 0.0;                            ///< since the begin
  std::vector<float> heights;                      ///< over each place of the stock mesh, mm
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();   ///< of the tool, mm
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ(); ///< of the tool, unit
};

/** Writes the surface of \p stock with the heights of \p moment as .vtp, point data Stock, mm; and a line of \p tool_length mm along the
 *  axis of the tool from its tip, with Stock 0. \p origin, mm, is added to the places. \throw FileError */
void writeMoment(const std::string& file, const StockMesh& stock, const CutMoment& moment, double tool_length,
                 const Eigen::Vector3d& origin = Eigen::Vector3d::Zero());

/** Writes the list of a time series, .pvd, which ParaView opens: \p names of the files of its moments, in the folder of \p file, and their
 *  times in s. \throw FileError */
void writeSeries(const std::string& file, const std::vector<std::string>& names, const std::vector<double>& seconds);

} // namespace pcl_spiral
