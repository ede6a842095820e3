// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Drops a cutter along its axis onto a mesh.
 */
#pragma once

#include "core/triangle_touch.h"
#include <pcl_spiral/cutter/impl/cutter_drop.h>
#include <pcl_spiral/mesh/impl/patch_tree.h>

#include <cstdint>
#include <limits>

namespace pcl_spiral {

/** The first contact of a cutter that moves down onto a mesh. */
struct MeshContact {
  bool found = false; ///< false: no part of the mesh within the cutter's radius of the axis, or above the floor
  double height = -std::numeric_limits<double>::infinity(); ///< of the tip along the axis, from the frame's origin
  std::uint32_t face = 0;
  Eigen::Vector3d weights = Eigen::Vector3d::Zero(); ///< barycentric, of the contact in the face
  Eigen::Vector3d contact = Eigen::Vector3d::Zero();
};

/** Finds the highest contact of a cutter with curved triangles, or with the flat ones of their corners, by best first search:
 *  boxes, then curved triangles, then their quarters, by bounds of the tip's height on them. The height on a flat triangle is
 *  exact (\see TriangleTouch). The bound of a curved triangle is the height on the flat one for a cutter that is wider by the part
 *  of the bows across the axis, plus the part of the bows up the axis. If the curved one lies within the sag of the flat one, the
 *  flat one is used. In hollows, where the bows lead down, the sag of a facet does not lift the cutter. The patches must outlive it. */
class MeshDrop {
public:
  /** \p sag: allowed distance from the curved surface, mm; infinite: triangles are flat. The cutter comes from \p ceiling along the axis,
   *  measured from the frame's origin: what is above it does not count, to the sag. */
  MeshDrop(const PatchTree& patches, const CutterProfile& profile, double sag, double ceiling = std::numeric_limits<double>::infinity())
  : patches_(patches), touch_(profile), sag_(sag), ceiling_(ceiling)
  {}

  const CutterProfile& profile() const { return touch_.profile(); }
  double sag() const { return sag_; }

  /** The contact at which nothing is gouged; of contacts at the same height, within 2e-9, the one on the face of the lowest index.
   *  Only contacts that hold the tip above \p floor count. */
  MeshContact highest(const AxisFrame& frame, double floor = -std::numeric_limits<double>::infinity()) const;

private:
  const PatchTree& patches_;
  TriangleTouch touch_;
  double sag_, ceiling_;
};

} // namespace pcl_spiral
