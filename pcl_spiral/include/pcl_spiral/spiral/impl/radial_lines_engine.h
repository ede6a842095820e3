// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Makes radial lines from the boundaries of a surface.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/features/boundary_loop.h>
#include <pcl_spiral/fit/impl/mls_surface.h>
#include <pcl_spiral/spiral/radial_line.h>
#include <pcl_spiral/spiral/spiral_settings.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pcl_spiral {

/** Input of radial lines. */
struct RadialLineRequest {
  const MlsSurface& surface;
  const BoundaryLoop& rim;
  const BoundaryLoop* inner = nullptr;        ///< second boundary, if any
  std::optional<Eigen::Vector3d> centre;      ///< one boundary only; absent: found
  std::optional<Eigen::Vector3d> start_point; ///< line 0 ends at the rim point nearest to it; absent: a corner, or the farthest
  LineMethod method = LineMethod::Automatic;
  double tolerance = 0.05;              ///< allowed error of a turn interpolated between lines, mm
  double fit_tolerance = 1e-3;          ///< allowed distance of a line's B-spline from its points, mm
  std::function<bool(double)> progress; ///< share done; false cancels
};

/** Make the lines: coarse ones evenly along the rim and on each of its corners. Then add one in the middle of every interval until
 *  the rim in it, and the last line found there, are interpolated to the tolerance. For geodesics from a centre, the last line needs
 *  only four times the tolerance, without the effect of the rim's own shape, because the interval is then half as wide.
 *
 *  Lines are geodesics (between paired ends if there are two boundaries). Behind re-entrant boundaries they can leave the surface,
 *  cross or jump. Then all lines become gradient lines of the harmonic function between the
 *  boundaries, which never cross.
 */
Status buildRadialLines(const RadialLineRequest& request, RadialLineSet& set);

} // namespace pcl_spiral
