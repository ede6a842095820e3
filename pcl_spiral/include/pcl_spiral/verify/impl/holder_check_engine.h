// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Checks shank and holder on the cutting moves of a path or a program.
 */
#pragma once

#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/common/status.h>
#include <pcl_spiral/core/cutter_profile.h>
#include <pcl_spiral/core/tool_holder.h>
#include <pcl_spiral/machine/machine_program.h>
#include <pcl_spiral/mesh/surface_mesh.h>
#include <pcl_spiral/search/impl/point_blocks.h>
#include <pcl_spiral/verify/figures.h>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** Shank and holder of a tool. */
struct UpperTool {
  HolderProfile shank, holder;

  double top() const { return holder.empty() ? shank.top() : holder.top(); } ///< height above the tip, mm
};

/** The tool above the cutting edge. The shank is as wide as \p cutter, from the centre of a ball or from the top of the flank of any
 *  other cutter up to \p holder; without a holder it has no end. The clearance is that of the holder. */
UpperTool upperTool(const CutterShape& cutter, const std::vector<ToolSegment>& holder, double clearance);

/** Cutting moves without a break, straight from pose to pose. */
struct CutRuns {
  std::vector<ToolPoses> runs;
  std::vector<std::size_t> moves; ///< of each pose, over all runs: the number of the move that ends there
  std::size_t count = 0;          ///< of the moves
};

/** The moves of \p passes; a move has the number of the pose where it ends, over all passes. InvalidInput if a pose is not finite. */
Status cutRuns(const std::vector<ToolPoses>& passes, CutRuns& runs);
/** The cutting moves of \p program, as the machine makes them, numbered by their blocks: tip and the place \p arm mm above it are nowhere
 *  farther than \p tolerance from the straight moves. */
Status cutRuns(const MachineProgram& program, double arm, double tolerance, CutRuns& runs);

/** No point may be deeper inside \p tool than \p tolerance mm. A stretch of the path is free if nothing is in the tool moved by as much
 *  as the tool moves on it; else it is halved. What may not be free is looked at in places no farther apart than the tolerance, or 0.1
 *  mm if that is more; between two of them at most half of that is missed. The same for any number of threads. The deepest place is that
 *  of the places looked at: all poses, and others where the poses are free. */
Status findHolderCollisions(const PointBlocks& points, const UpperTool& tool, const CutRuns& runs, double tolerance,
                            const ProgressCallback& progress, LeadReport& figures);
/** The same with the curved surface behind the faces of \p mesh, to within 1e-3 mm. */
Status findHolderCollisions(const SurfaceMesh& mesh, const UpperTool& tool, const CutRuns& runs, double tolerance,
                            const ProgressCallback& progress, LeadReport& figures);

} // namespace pcl_spiral
