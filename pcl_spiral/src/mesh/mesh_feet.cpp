// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_feet.h"

#include <limits>

namespace pcl_spiral {

MeshFoot
MeshFeet::of(const Eigen::Vector3d& place) const
{
  constexpr double sag = 1e-4;     // mm: parts of faces nearer than this to the curved surface represent it
  constexpr double on_side = 1e-9; // a share
  PatchPlace nearest;
  faces_.nearest(place, std::numeric_limits<double>::infinity(), sag, nearest);
  MeshFoot foot{nearest.patch, nearest.weights, nearest.position, mesh_.patch(nearest.patch).normal(nearest.weights), nearest.distance,
                false};
  for (int k = 0; k < 3; ++k)
    if (foot.weights[(k + 2) % 3] < on_side &&
        mesh_.triangles().opposite(3 * foot.face + static_cast<std::uint32_t>(k)) == Triangulation::none)
      foot.beyond = true;
  return foot;
}

} // namespace pcl_spiral
