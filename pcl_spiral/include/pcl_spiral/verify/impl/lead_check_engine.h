// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Checks the moves of a program off its path against the points of a scan.
 */
#pragma once

#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/common/status.h>
#include <pcl_spiral/core/cutter_profile.h>
#include <pcl_spiral/core/tool_holder.h>
#include <pcl_spiral/machine/machine_program.h>
#include <pcl_spiral/search/impl/point_blocks.h>
#include <pcl_spiral/verify/figures.h>

#include <cstddef>

namespace pcl_spiral {

/** Checks all moves of \p program that do not cut, and every rapid, as the machine makes them. No point may be deeper
 *  inside than \p tolerance mm in \p cutter (along its normals), in a shank of the same width above it, or in \p holder.
 *  A move is checked at places close together. Between two places, cutter and shank miss at most half the tolerance
 *  (sweptError, and the wedge between two shanks up to the top of the scan). A holder misses at most half of 0.1 mm
 *  or half of the tolerance, whichever is larger. The move from the machine's first position to the first block is not
 *  known, and not checked. The same for any number of threads. Fails on a program without moves, or when cancelled. */
Status findLeadCollisions(const PointBlocks& points, const CutterProfile& cutter, const HolderProfile& holder,
                          const MachineProgram& program, double tolerance, const ProgressCallback& progress, LeadReport& figures);

} // namespace pcl_spiral
