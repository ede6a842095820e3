// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Refines rough lines on a surface to geodesics.
 */
#pragma once

#include <pcl_spiral/fit/impl/mls_surface.h>
#include <pcl_spiral/geodesic/geodesic_line.h>

#include <vector>

namespace pcl_spiral {

/** How lines are refined to geodesics; the setters of GeodesicPath explain it. */
struct RefinementOptions {
  std::vector<int> levels{16, 32, 64, 128}; ///< segments of a line, coarse to fine; the last is the result's
  int max_iterations = 30;                  ///< per level
  double tolerance = 0.001;                 ///< mm: largest move at which a line counts as converged
  RefinementMethod method = RefinementMethod::TridiagonalNewton;
  bool probe_normals = true; ///< correct the normals by feet beside the line, at the end: half as much work again
};

/** Turn lines that start from a trace or graph path into geodesics: lines[i].points, at least two each.
 *
 *  All lines are projected together, once per iteration. Every accepted move shortens its line. A line that cannot continue
 *  because the surface ends keeps its last position on the surface, with left_surface set; it is then not
 *  a geodesic. The same bytes for any number of threads.
 */
void refineGeodesics(const MlsSurface& surface, const RefinementOptions& options, std::vector<GeodesicLine>& lines);

} // namespace pcl_spiral
