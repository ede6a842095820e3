// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The way uphill over a field from node to node.
 */
#pragma once

#include <pcl_spiral/spiral/step_over_field.h>

#include "geodesic/mesh_walk.h"

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** For every node of a field: the neighbour in the direction of steepest rise of D, and the summit at the end of that way. A local
 *  summit that comes from noise, with a higher node within 0.8 step-overs, leads on to that node. */
class RidgeClimb {
public:
  static constexpr std::uint32_t none = 0xffffffffu;

  explicit RidgeClimb(const StepOverDistance& field);

  /** Next node uphill; none on a summit. */
  std::uint32_t up(std::uint32_t v) const { return up_[v]; }
  std::uint32_t summit(std::uint32_t v) const { return summit_[v]; }

private:
  void findSummits();
  std::uint32_t higherNode(const StepOverDistance& field, std::uint32_t v) const;

  std::vector<std::uint32_t> up_, summit_;
};

/** Length of the edge from \p a to \p b in step-overs. */
inline double
edgeLength(const StepOverMesh& mesh, std::uint32_t a, std::uint32_t b)
{
  return between(mesh.metric[a], mesh.metric[b], 0.5).length(mesh.positions[b] - mesh.positions[a]);
}

} // namespace pcl_spiral
