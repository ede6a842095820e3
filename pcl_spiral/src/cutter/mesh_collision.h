// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Shank and holder against a mesh. Private.
 */
#pragma once

#include <pcl_spiral/cutter/impl/holder_collision.h>
#include <pcl_spiral/mesh/impl/patch_tree.h>

namespace pcl_spiral {

/** The deepest place of the \p patches in the holder, deeper than \p tolerance, when the tip stands at \p tip along the axis
 *  of \p frame; cloud_index is that of the patch. Triangles are cut into quarters, only where a bound of the depth asks for it:
 *  any place deeper than the one found by more than 1e-3 mm, or than the tolerance by as much where none is found, is ruled
 *  out, large facets without a vertex nearby too. Where that takes more than 20,000 cuts the bound itself is reported. \p sag: how near
 *  the triangles are to be taken to the curved surface; infinite: they are flat. */
HolderCollision findCollision(const PatchTree& patches, const HolderProfile& holder, const AxisFrame& frame, double tip, double tolerance,
                              double sag);

} // namespace pcl_spiral
