// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Points along the boundary of a mesh. Private to mesh.
 */
#pragma once

#include <pcl_spiral/mesh/surface_mesh.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

struct RimSample {
  Eigen::Vector3f position, normal;
  std::uint32_t face;
};

/** Points of the rims of the chosen faces: at their corners, and between these at even distances of up to \p step. Of rims that
 *  coincide, as along a seam that was not joined, points nearer than \p apart to others are left out. */
std::vector<RimSample> rimSamples(const SurfaceMesh& mesh, const std::vector<std::uint8_t>& chosen, double step, double apart);

} // namespace pcl_spiral
