// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Settings of the surface of a scan.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/height_grid.h>
#include <pcl_spiral/core/setting.h>

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace pcl_spiral {

/** What to do with points that stand off the surface together: a screw, a clamp, weld spatter; or several false echoes. */
enum class ClusterHandling {
  Refuse,   ///< fail, with place, size and height of each
  LeaveOut, ///< leave them out as outliers, with a warning: a path goes through them
  Ride      ///< leave them out of the surface; the ball of a spiral rides over them and never cuts into them
};

/** Settings of ScannedSurface; its setters explain them. Lengths in mm. */
struct SurfaceSettings {
  std::optional<Eigen::Vector3d> view_point;          ///< normals face it; absent: the sensor of the cloud, else +z as a whole
  std::optional<HeightGrid> heights;                  ///< the points are nodes of this grid, see BallClosing: nothing is left out
  bool flip_normals = false;                          ///< turn all normals to the other side
  bool largest_part = false;                          ///< keep only the part with the largest area if there are several
  std::optional<Eigen::Vector3d> part_at;             ///< of several parts keep the one nearest to this place
  ClusterHandling clusters = ClusterHandling::Refuse; ///< what to do with points that stand off the surface together
  double thinning = 0.0;                              ///< voxel edge of the thinning filter; 0: no thinning
  int outlier_neighbours = 0;                         ///< of the statistical outlier filter; 0: no filter
  double outlier_deviations = 3.0;                    ///< its threshold in standard deviations
  int neighbours = 32;                                ///< in one neighbourhood, to start with
  double alpha = 3.0;                                 ///< radius of the largest circle without points that is still surface, in spacings
  bool trust_normals = true;                          ///< refuse input normals without a common side; false: do not use them, and warn
  bool strict = true;                                 ///< refuse a scan that is no single sheet or is badly connected
  unsigned int threads = 0;                           ///< 0: all; the surface does not depend on it
};

/** All of them but strict, which each class sets itself. */
std::vector<Setting> settingTable(SurfaceSettings& settings);

/** Name of the first setter that \p asked uses and \p made does not agree with; empty if there is none. A setting
 *  \p asked leaves at its default agrees with everything. strict, trust_normals and threads are
 *  not compared. */
Diagnostic disagreement(SurfaceSettings asked, SurfaceSettings made);

} // namespace pcl_spiral
