// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A cutter brought down along its axis onto a mesh.
 */
#pragma once

#include "core/triangle_touch.h"
#include <pcl_spiral/cutter/impl/cutter_drop.h>
#include <pcl_spiral/mesh/impl/patch_tree.h>

#include <cstdint>
#include <limits>

namespace pcl_spiral {

/** What a cutter coming down on a mesh meets first. */
struct MeshContact {
  bool found = false; ///< false: no part of the mesh within the cutter's radius of the axis, or above the floor
  double height = -std::numeric_limits<double>::infinity(); ///< of the tip along the axis, from the frame's origin
  std::uint32_t face = 0;
  Eigen::Vector3d weights = Eigen::Vector3d::Zero(); ///< barycentric, of the contact in the face
  Eigen::Vector3d contact = Eigen::Vector3d::Zero();
};

/** Finds the highest contact of a cutter with curved triangles, or with the flat ones of their corners, by best first search:
 *  boxes, then curved triangles, then their quarters, by bounds of the tip's height on them. The height on a flat triangle is
 *  exact (\see TriangleTouch). A curved triangle is bounded by the flat one of a cutter that is wider by as much as the bows
 *  lead across the axis, and higher by as much as they lead up it; where it lies within the sag of the flat one it is taken
 *  for that. In hollows, where the bows lead down, a facet's own sag does not lift the cutter. The patches must outlive it. */
class MeshDrop {
public:
  /** \p sag: how near to the curved surface, mm; infinite: triangles are flat. */
  MeshDrop(const PatchTree& patches, const CutterProfile& profile, double sag) : patches_(patches), touch_(profile), sag_(sag) {}

  const CutterProfile& profile() const { return touch_.profile(); }
  double sag() const { return sag_; }

  /** The location without gouge; of contacts as high, to 2e-9, that on the face of the lowest index. Only what holds the tip above
   *  \p floor counts. */
  MeshContact highest(const AxisFrame& frame, double floor = -std::numeric_limits<double>::infinity()) const;

private:
  const PatchTree& patches_;
  TriangleTouch touch_;
  double sag_;
};

} // namespace pcl_spiral
