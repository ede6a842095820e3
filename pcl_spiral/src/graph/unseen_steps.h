// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Steps of a cloud whose side was not scanned. Private.
 */
#pragma once

#include <pcl_spiral/graph/impl/triangulation.h>
#include <pcl_spiral/search/impl/point_blocks.h>

#include <Eigen/Core>

#include <vector>

namespace pcl_spiral {

/** A triangulated cloud, one entry per point. */
struct TriangulatedPoints {
  const PointBlocks& blocks;
  const std::vector<Eigen::Vector3f>& normals; ///< to the outer side
  const std::vector<float>& radii;             ///< of their neighbourhoods, mm
  float spacings_per_radius;                   ///< local spacing of the points by that radius
};

/** One flag per triangle, 1 for the triangles over steps whose side was not scanned, if all that joins two surfaces is such a step: a part
 *  and the table below it, a thing and the part that it stands on; empty if there is none. No surface is known between them. Stars meet
 *  there, since from above the two are only a spacing apart. A smaller surface below, such as the floor of a pocket, stays with its part.
 *
 *  Steps are edges far longer than the spacing and steep to the surface at both ends. Without the triangles about them the mesh falls into
 *  surfaces; each point at a step then goes to the surface whose plane it is nearest to, and triangles with corners on two of them go. */
std::vector<std::uint8_t> unseenSteps(const TriangulatedPoints& cloud, const Triangulation& mesh);

} // namespace pcl_spiral
