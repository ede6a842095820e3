// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Shank and holder against a mesh. Private.
 */
#pragma once

#include <pcl_spiral/cutter/impl/holder_collision.h>
#include <pcl_spiral/mesh/impl/patch_tree.h>

#include <limits>

namespace pcl_spiral {

/** The deepest place of the \p patches in the holder, deeper than \p tolerance, with the tip at \p tip along the axis
 *  of \p frame; cloud_index is that of the patch. Triangles are cut into quarters only if a bound of the depth needs it. No
 *  place is deeper by more than 1e-3 mm than the one found, or than the tolerance if none is found; this holds for large facets without
 *  a vertex nearby too. If that needs more than 20,000 cuts, the bound itself is reported. \p sag: allowed distance of
 *  the triangles from the curved surface; infinite: they are flat. Only what
 *  is above \p above along the axis counts. */
HolderCollision findCollision(const PatchTree& patches, const HolderProfile& holder, const AxisFrame& frame, double tip, double tolerance,
                              double sag, double above = -std::numeric_limits<double>::infinity());

/** Whether a place of the \p patches may be deeper than \p tolerance in the holder, with the tip at the origin of \p frame or at any
 *  place within \p sway of it. False only if none is deeper by more than 1e-3 mm. */
bool mayCollide(const PatchTree& patches, const HolderProfile& holder, const AxisFrame& frame, const ToolSway& sway, double tolerance,
                double sag);

} // namespace pcl_spiral
