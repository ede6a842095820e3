/** \file
 *  How far the contacts of a path stand off the surface they are judged by.
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
  std::size_t points = 0;     ///< of the path
  std::size_t measured = 0;   ///< among the points of the scan: the figures are theirs
  std::size_t beyond_rim = 0; ///< just outside the outermost points, measured against the surface carried on
  std::size_t unmeasured = 0; ///< no surface there
  double rms = 0.0, p99 = 0.0; ///< of the deviation's amount
  PlacedValue max;            ///< the largest in amount, with its sign: positive out of the material
  PlacedValue rim_max;        ///< the same of those beyond the rim
  std::size_t in_gaps = 0;    ///< in gaps of the scan: nothing there to judge by
  PlacedValue gap_max;        ///< the largest distance of those near its edge from the surface carried on
  std::size_t in_crease_band = 0; ///< within crease_band of a crease of the mesh, where a fit rounds it: no part of the other figures
  double crease_band = 0.0;   ///< ReferenceSurface::creaseBand
  PlacedValue crease_max;     ///< the largest distance of those from the rounded fit, with its sign: no verdict
  PlacedValue normal_error;   ///< largest angle between the path's normal and the surface's
  double normal_p99 = 0.0;
  std::size_t opposed = 0; ///< points whose normal points into the material
  PlacedValue first_opposed;
  std::size_t inward_axes = 0; ///< points whose tool axis points into the material: the shank would go there
  PlacedValue first_inward;
  TurnWobble wobble;          ///< of the deviation, from turn to turn
  PathMotion motion;
  std::size_t reference_points = 0;
  bool by_mesh = false;   ///< its samples are the reference points; else it is a scan's
  double noise = 0.0;     ///< ReferenceSurface::noise
  double fit_noise = 0.0; ///< ReferenceSurface::fitNoise: deviations below three times this are not known
  double seconds = 0.0;
  std::vector<std::string> warnings;
};

/** Signed deviation of each path point, NaN where it is not measured, and the figures. \p chord_error is
 * compared with the noise, 0 for none. Fails when no point lies on the scan, and when \p progress cancels. */
Status
measureDeviation(const ReferenceSurface& reference, const CutterPath& path, double chord_error,
                 const ProgressCallback& progress, std::vector<float>& deviation, DeviationFigures& figures);

} // namespace pcl_spiral
