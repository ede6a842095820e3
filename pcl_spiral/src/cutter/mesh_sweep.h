// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A ball cutter led straight over a mesh. Private.
 */
#pragma once

#include <pcl_spiral/mesh/impl/patch_tree.h>

namespace pcl_spiral {

/** Finds how deep a ball cutter and the shank of its radius, without end, cut into curved triangles on a straight move, the axis
 *  unchanged: the radius less the distance from the strip that the axis sweeps (\see SweptStrip), exact for flat triangles. Curved
 *  ones are cut into quarters until within the sag of flat ones. The patches must outlive it. Any number of threads may ask. */
class MeshSweep {
public:
  /** \p sag: how near to the curved surface, mm; infinite: triangles are flat. */
  MeshSweep(const PatchTree& patches, double radius, double sag) : patches_(patches), radius_(radius), sag_(sag) {}

  /** Depth of the deepest place, to the sag, of a move of the ball's centre between \p from and \p to; \p allowed where none is
   *  deeper. \p axis unit. */
  double depth(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Eigen::Vector3d& axis, double allowed) const;
  /** Whether, all the way, some place of the patches is no farther than \p off off the ball. */
  bool touches(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Eigen::Vector3d& axis, double off) const;

private:
  const PatchTree& patches_;
  double radius_, sag_;
};

} // namespace pcl_spiral
