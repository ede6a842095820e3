/** \file
 *  How a surface is made of a cloud.
 */
#pragma once

#include <Eigen/Core>

#include <optional>
#include <string>

namespace pcl_spiral {

/** Settings of ScannedSurface, whose setters say more. Lengths in mm. */
struct SurfaceSettings {
  std::optional<Eigen::Vector3d> view_point; ///< normals face it; absent: towards +z as a whole
  bool flip_normals = false;
  bool largest_part = false;        ///< of several separate parts keep the one of the largest area alone
  double thinning = 0.0;            ///< voxel edge of the thinning filter; 0: none
  int outlier_neighbours = 0;       ///< of the statistical outlier filter; 0: none
  double outlier_deviations = 3.0;  ///< its threshold in standard deviations
  int neighbours = 32;              ///< in one neighbourhood, to start with
  double alpha = 3.0;               ///< largest circle free of points that is surface: its radius in spacings
  bool strict = true;               ///< refuse what is no single sheet, or hangs together badly
};

/** The first setter, by its name, that \p asked uses and \p made does not agree with; empty where there is none. What
 *  \p asked leaves at its default agrees with everything, and strict is not compared. */
std::string
disagreement(const SurfaceSettings& asked, const SurfaceSettings& made);

} // namespace pcl_spiral
