// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The small disc about the centre, where a harmonic function has a singularity of known shape.
 */
#pragma once

#include "harmonic_domain.h"

namespace pcl_spiral {

/** The triangle under \p centre, or Triangulation::none if it is off the surface or in a gap. */
std::uint32_t triangleAt(const SurfaceGraph& graph, const Eigen::Vector3d& centre);

/** Points within two spacings of the domain's centre, with their directions. The domain must be cut from
 *  \p triangle, the one under the centre. */
Status makeCentreDisc(const SurfaceGraph& graph, std::uint32_t triangle, HarmonicDomain& domain);

} // namespace pcl_spiral
