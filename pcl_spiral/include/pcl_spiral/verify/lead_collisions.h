/** \file
 *  A program's moves off its path, against the points of a scan.
 */
#pragma once

#include <pcl_spiral/common/progress.h>
#include <pcl_spiral/common/status.h>
#include <pcl_spiral/core/cutter_profile.h>
#include <pcl_spiral/core/tool_holder.h>
#include <pcl_spiral/machine/machine_program.h>
#include <pcl_spiral/search/point_blocks.h>

#include <cstddef>

namespace pcl_spiral {

/** Where the tool would be in the scan. Lengths in mm. */
struct LeadCollision {
  BlockSection section = BlockSection::Position;
  std::size_t block = 0; ///< of the program: the end of the move
  int segment = -1;      ///< of the holder, from the cutter upwards; -1: the cutter, or a shank as wide as it
  double depth = 0.0;    ///< how much higher along its axis the cutter would have to stand; of a segment the shortest way out
  Eigen::Vector3d place = Eigen::Vector3d::Zero(); ///< the point of the scan
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();
};

struct LeadFigures {
  std::size_t moves = 0;    ///< that do not cut
  std::size_t collided = 0; ///< of these
  LeadCollision deepest;    ///< where there is one
};

/** Look at all moves of \p program that do not cut, rapids among them, as the machine makes them: \p cutter, a shank as
 *  wide above it, and \p holder must have no point deeper inside than \p tolerance mm, for the cutter along its normals.
 *  A move is looked at in places so close together that sweptError between them is below half the tolerance.
 *  The same for any number of threads. Fails when cancelled. */
Status
findLeadCollisions(const PointBlocks& points, const CutterProfile& cutter, const HolderProfile& holder,
                   const MachineProgram& program, double tolerance, const ProgressCallback& progress,
                   LeadFigures& figures);

} // namespace pcl_spiral
