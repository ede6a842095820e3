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

#include <cstddef>

namespace pcl_spiral {

/** Part of the tool. */
enum class ToolPart {
  Cutter, ///< up to the top of its flank
  Shank,  ///< above the cutter, as wide as the cutter, without an end
  Holder
};

/** A place where the tool would be in the scan. Lengths in mm. */
struct LeadCollision {
  ToolPart part = ToolPart::Cutter;
  BlockSection section = BlockSection::Position;
  std::size_t block = 0; ///< of the program: the end of the move
  int segment = -1;      ///< of the holder, from the cutter upwards; -1: none
  double depth = 0.0;    ///< of the point in the tool; for cutter and shank the shorter way out, along the axis or across it
  Eigen::Vector3d place = Eigen::Vector3d::Zero(); ///< the point of the scan
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();
};

struct LeadFigures {
  std::size_t moves = 0;    ///< moves that do not cut
  std::size_t collided = 0; ///< number of these moves with a collision
  LeadCollision deepest;    ///< if there is one
};

/** Checks all moves of \p program that do not cut, also rapids, as the machine makes them. No point may be deeper
 *  inside than \p tolerance mm in \p cutter (along its normals), in a shank of the same width above it, or in \p holder.
 *  A move is checked at places close together. Between two places, cutter and shank miss at most half the tolerance
 *  (sweptError, and the wedge between two shanks up to the top of the scan). A holder misses at most half of 0.1 mm
 *  or half of the tolerance, whichever is larger. The move from the machine's first position to the first block is not
 *  known, and not checked. The same for any number of threads. Fails on a program without moves, or when cancelled. */
Status findLeadCollisions(const PointBlocks& points, const CutterProfile& cutter, const HolderProfile& holder,
                          const MachineProgram& program, double tolerance, const ProgressCallback& progress, LeadFigures& figures);

} // namespace pcl_spiral
