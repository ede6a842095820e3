// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The outer side of a surface in words.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/graph/outer_side.h>

namespace pcl_spiral {

/** Name of \p vote: "given normals", "view point", "+z" or "convex". */
const char* nameOf(SideVote vote);

/** What decided the outer side and how clearly, in one line. */
Diagnostic sideText(const OuterSide& side);

/** Warnings if the vote is weak or much of the surface disagrees with it, with the remedy. Empty if the side is clear, or if
 *  the user asked for the other side. */
Diagnostics sideWarnings(const OuterSide& side);

/** A warning if the vote is that of a view point on the other side than +z, which nobody set: it came with the cloud. */
Diagnostics sensorWarnings(const OuterSide& side);

} // namespace pcl_spiral
