// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Settings that make a surface from a cloud.
 */
#pragma once

#include <Eigen/Core>

#include <optional>
#include <string>

namespace pcl_spiral {

/** Settings of ScannedSurface; its setters explain them. Lengths in mm. */
struct SurfaceSettings {
  std::optional<Eigen::Vector3d> view_point; ///< normals face it; absent: towards +z as a whole
  bool flip_normals = false;
  bool largest_part = false;       ///< keep only the part with the largest area if there are several
  double thinning = 0.0;           ///< voxel edge of the thinning filter; 0: no thinning
  int outlier_neighbours = 0;      ///< of the statistical outlier filter; 0: no filter
  double outlier_deviations = 3.0; ///< its threshold in standard deviations
  int neighbours = 32;             ///< in one neighbourhood, to start with
  double alpha = 3.0;              ///< radius of the largest circle without points that is still surface, in spacings
  bool strict = true;              ///< refuse a scan that is no single sheet or is badly connected
};

/** Name of the first setter that \p asked uses and \p made does not agree with; empty if there is none. A setting
 *  \p asked leaves at its default agrees with everything. strict is not compared. */
std::string disagreement(const SurfaceSettings& asked, const SurfaceSettings& made);

} // namespace pcl_spiral
