/** \file
 *  A program's moves off its path, against the points of a scan.
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

/** What of the tool. */
enum class ToolPart {
  Cutter, ///< up to the top of its flank
  Shank,  ///< above it, as wide as the cutter, without an end
  Holder
};

/** Where the tool would be in the scan. Lengths in mm. */
struct LeadCollision {
  ToolPart part = ToolPart::Cutter;
  BlockSection section = BlockSection::Position;
  std::size_t block = 0; ///< of the program: the end of the move
  int segment = -1;      ///< of the holder, from the cutter upwards; -1: none
  double depth = 0.0;    ///< of the point in the tool: of cutter and shank the shorter way out along the axis or across it
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
 *  A move is looked at in places so close together that cutter and shank miss no more than half the tolerance between them
 *  (sweptError, and the wedge between two shanks as far up as the scan goes), and a holder no more than half of 0.1 mm or of
 *  the tolerance, whichever is larger. The move from where the machine stands to the first block is not known, and not
 *  looked at. The same for any number of threads. Fails on a program without moves, or when cancelled. */
Status
findLeadCollisions(const PointBlocks& points, const CutterProfile& cutter, const HolderProfile& holder,
                   const MachineProgram& program, double tolerance, const ProgressCallback& progress,
                   LeadFigures& figures);

} // namespace pcl_spiral
