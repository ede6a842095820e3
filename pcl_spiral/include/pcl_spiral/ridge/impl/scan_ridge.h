/** \file
 *  Rail and generator of a ridge out of the surface of a full scan.
 */
#pragma once

#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/common/status.h>
#include <pcl_spiral/core/impl/polyline.h>
#include <pcl_spiral/ridge/ridge_surface.h>
#include <pcl_spiral/surface/surface.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl_spiral {

/** What is looked for in a scan. Lengths in mm. */
struct ScanRidgeSettings {
  Polyline rough_points;  ///< at the wanted ends of the ridge and, where it bends, between; of a closed one all round
  bool closed = false;    ///< the ridge is a ring
  double half_width = 0.0; ///< how far the generator goes to either side of the crest, along the surface
  Eigen::Vector3d reference = Eigen::Vector3d::UnitZ(); ///< normal of the reference plane, \see RidgeSettings
  double point_spacing = 0.0; ///< of both lines; 0: twice that of the scan
  int most_rounds = 30;       ///< of aligning the sections
};

/** What was found. Lengths in mm. */
struct ScanRidgeReport {
  std::size_t sections = 0; ///< across the ridge that were aligned
  std::size_t points = 0;   ///< of the scan in the band of the ridge
  int rounds = 0;           ///< until rail and generator stood still
  double last_move = 0.0;   ///< of the rail in the last round, rms, but for what all of it moved by
  double noise = 0.0;       ///< of the scan: standard deviation of a point about its surface
  double reach_left = 0.0, reach_right = 0.0; ///< of the generator from the crest, along it: to its start, and to its end
  double crest_wander = 0.0; ///< rms distance of the crest from the rail that was found, across it
  double misfit = 0.0;      ///< rms distance of the points from the swept surface, the scan's noise included
  double largest_misfit = 0.0; ///< the largest of the medians of small cells of the surface, so that noise has little part in it
  Eigen::Vector3d largest_place = Eigen::Vector3d::Zero(); ///< middle of that cell
  Polyline crest;           ///< where the larger curvature is largest, which the search begins with
  std::vector<std::string> warnings;
};

/** Both lines, ready for RidgeSurface::make, and what came of it. */
struct ScanRidge {
  Polyline rail;      ///< evenly spaced; of a ring the first point does not come again
  Polyline generator; ///< in the rail's normal plane, at 0.45 of the rail's length
  RidgeSurface::ConstPtr ridge; ///< up is the outer side of the scan: its settings().flip says whether it had to be flipped
  ScanRidgeReport report;
};

/** Ok, or what is out of range. */
Status checkScanRidgeSettings(const ScanRidgeSettings& settings);

/** Find the ridge of \p surface. Begins at the crest of the larger curvature; then in rounds, until nothing moves: the points of the
 *  scan are put in sections by normal planes of the rail, in the local coordinates of its frame; the generator is shifted within each plane until
 *  it lies on that section (least squares along its normals); the mean of the sections, shifted back, is the new generator, a
 *  smooth curve through the shifted origins the new rail. Nothing moves: the rail's move, rms, is below 0.3 of the standard error of
 *  a section's place, noise / sqrt(points of a section), 0.2 of the misfit that no shift takes away, or a hundred-thousandth of the half width.
 *
 *  InvalidArgument: a setting out of range. InvalidInput, with place, value and remedy: fewer than two rough points (closed: three),
 *  one off the scan, no crest between them, a band that runs off the scan, no end of the rounds, and what RidgeSurface::make refuses. */
Status findScanRidge(const Surface& surface, const ScanRidgeSettings& settings, const ProgressCallback& progress, ScanRidge& result);

} // namespace pcl_spiral
