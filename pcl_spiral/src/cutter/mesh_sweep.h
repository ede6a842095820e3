// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A ball cutter on a straight move over a mesh. Private.
 */
#pragma once

#include <pcl_spiral/mesh/impl/patch_tree.h>

namespace pcl_spiral {

/** Finds how deep a ball cutter and an endless shank of its radius cut into curved triangles on a straight move with a fixed axis:
 *  the radius minus the distance from the strip that the axis sweeps (\see SweptStrip), exact for flat triangles. Curved triangles
 *  are cut into quarters until they are within the sag of flat ones. The patches must outlive it. Any number of threads may call it. */
class MeshSweep {
public:
  /** \p sag: allowed distance from the curved surface, mm; infinite: triangles are flat. */
  MeshSweep(const PatchTree& patches, double radius, double sag) : patches_(patches), radius_(radius), sag_(sag) {}

  /** Depth of the deepest place, to the sag, of a move of the ball's centre between \p from and \p to; \p allowed if none is
   *  deeper. \p axis unit. */
  double depth(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Eigen::Vector3d& axis, double allowed) const;
  /** Whether, all the way, some place of the patches is within \p off of the ball. */
  bool touches(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Eigen::Vector3d& axis, double off) const;

private:
  const PatchTree& patches_;
  double radius_, sag_;
};

} // namespace pcl_spiral
