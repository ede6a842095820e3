// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Geodesics from one source to many targets.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/geodesic/impl/geodesic_refinement.h>

#include <vector>

namespace pcl_spiral {

/** Geodesics from \p source to each of \p targets, in their order. Lines that were not found have no points, or have
 *  left_surface set. The status is Failed if there is such a line, with the first one and the remedy in its message; Ok with a
 *  remark in the message if lines have not converged to the tolerance. */
Status shortestPaths(const MlsSurface& surface, const Eigen::Vector3d& source, const Polyline& targets, GeodesicStart start,
                     const RefinementOptions& options, std::vector<GeodesicLine>& lines);

/** Why \p options cannot be used; Ok if they can. */
Status checkRefinement(const RefinementOptions& options);

} // namespace pcl_spiral
