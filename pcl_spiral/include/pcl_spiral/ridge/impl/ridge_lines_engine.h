// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Finds rail and generator of a ridge in the surface of a full scan.
 */
#pragma once

#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/common/status.h>
#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/ridge/ridge_surface.h>
#include <pcl_spiral/surface/surface.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl_spiral {

/** What to look for in a scan. Lengths in mm. */
struct ScanRidgeSettings {
  Polyline rough_points;   ///< at the wanted ends of the ridge and, where it bends, between; of a closed ridge all round it
  bool closed = false;     ///< the ridge is a ring
  double half_width = 0.0; ///< how far the generator extends to either side of the crest, along the surface
  Eigen::Vector3d reference = Eigen::Vector3d::UnitZ(); ///< normal of the reference plane, \see RidgeSettings
  double point_spacing = 0.0;                           ///< of both lines; 0: twice that of the scan
  int most_rounds = 30;                                 ///< largest number of rounds that align the sections
};

/** Both lines, ready for RidgeSurface::make, and the report. */
struct ScanRidge {
  Polyline rail;                ///< evenly spaced; on a ring the first point is not repeated
  Polyline generator;           ///< in the normal plane of the rail, at 0.45 of the rail's length
  RidgeSurface::ConstPtr ridge; ///< up is the outer side of the scan; settings().flip of the ridge reports whether it had to be flipped
  ScanRidgeReport report;
};

/** Ok, or what is out of range. */
Status checkScanRidgeSettings(const ScanRidgeSettings& settings);

/** Finds the ridge of \p surface. It begins at the crest of the larger curvature, then works in rounds. Normal planes of the rail put
 *  the scan points in sections, in the local coordinates of its frame. The generator is shifted within each plane until it lies on
 *  that section (least squares along its normals). The mean of the sections, shifted back, is the new generator; a smooth curve through
 *  the shifted origins is the new rail. The rounds end when the rail's rms move is below one of these: 0.3 of the standard error of a
 *  section's place, noise / sqrt(points of a section); 0.2 of the misfit that no shift removes; a hundred-thousandth of the half width.
 *
 *  InvalidArgument: a setting out of range. InvalidInput, with place, value and remedy: fewer than two rough points (closed: three),
 *  one off the scan, no crest between them, a band that runs off the scan, rounds that do not end, what RidgeSurface::make refuses. */
Status findScanRidge(const Surface& surface, const ScanRidgeSettings& settings, const ProgressCallback& progress, ScanRidge& result);

} // namespace pcl_spiral
