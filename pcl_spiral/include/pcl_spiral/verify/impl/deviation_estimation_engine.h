// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Distance of the contacts of a path from the surface by which they are judged.
 */
#pragma once

#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/verify/impl/cutter_path.h>
#include <pcl_spiral/verify/impl/reference_surface.h>
#include <pcl_spiral/verify/impl/turn_wobble.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl_spiral {

/** Figures of a path against a scan or a mesh. Lengths in mm, angles in degrees. */
struct DeviationFigures {
  std::size_t points = 0;         ///< of the path
  std::size_t measured = 0;       ///< points with data of the scan around them: the figures are for these
  std::size_t beyond_rim = 0;     ///< just outside the outermost points; measured against the extended surface
  std::size_t unmeasured = 0;     ///< no surface there
  double rms = 0.0, p99 = 0.0;    ///< of the absolute deviation
  PlacedValue max;                ///< the largest in absolute value, with its sign: positive out of the material
  PlacedValue rim_max;            ///< the same for the points beyond the rim
  std::size_t in_gaps = 0;        ///< in gaps of the scan, where there is no data to judge by
  PlacedValue gap_max;            ///< near the border of a gap: the largest distance from the extended surface
  std::size_t in_crease_band = 0; ///< within crease_band of a crease of the mesh, where a fit rounds it; not part of the other figures
  double crease_band = 0.0;       ///< see ReferenceSurface::creaseBand
  PlacedValue crease_max;         ///< the largest distance of these from the rounded fit, with its sign; not a verdict
  PlacedValue normal_error;       ///< largest angle between the path's normal and the surface's
  double normal_p99 = 0.0;
  std::size_t opposed = 0; ///< points whose normal points into the material
  PlacedValue first_opposed;
  std::size_t inward_axes = 0; ///< points whose tool axis points into the material: the shank would go there
  PlacedValue first_inward;
  TurnWobble wobble; ///< of the deviation, from turn to turn
  PathMotion motion;
  std::size_t reference_points = 0;
  bool by_mesh = false;   ///< the reference points are samples of a mesh; false: a scan
  double noise = 0.0;     ///< see ReferenceSurface::noise
  double fit_noise = 0.0; ///< see ReferenceSurface::fitNoise; deviations below three times this are not known
  double seconds = 0.0;
  std::vector<std::string> warnings;
};

/** Signed deviation of each path point, NaN where it is not measured, and the figures. \p chord_error is compared
 *  with the noise; 0: no comparison. Fails if no point lies on the scan, and when \p progress cancels. */
Status measureDeviation(const ReferenceSurface& reference, const CutterPath& path, double chord_error, const ProgressCallback& progress,
                        std::vector<float>& deviation, DeviationFigures& figures);

} // namespace pcl_spiral
