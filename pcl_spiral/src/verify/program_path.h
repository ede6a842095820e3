// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The way of a cutter along a machine program.
 */
#pragma once

#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/core/cutter_profile.h>
#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/machine/machine_program.h>
#include <pcl_spiral/verify/impl/reference_surface.h>

#include <pcl/point_cloud.h>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** Lengths in mm. */
struct ProgramPathSettings {
  CutterShape cutter;
  double tolerance = 1e-3; ///< of the ball's centre, and of another cutter's tip and the point R above it, from the straight line between
                           ///< points of the path
  double air = 1.0;        ///< a cutter higher than this above the scan does not cut
  bool axis_arcs = false;  ///< see ProgramFile
};

/** Whether the move to \p block may be a cut: at feed, and not marked as a link. */
bool mayCut(const ProgramBlock& block);

/** The feed moves of a program that cut, as a path. */
struct ProgramPath {
  pcl::PointCloud<ToolpathPoint> path; ///< contacts; a lift between passes adds no arc length, turn is the number of the pass
  std::vector<std::size_t> blocks;     ///< of each point: the block that leads to it
  Polyline tips;                       ///< of each point
  std::size_t passes = 0;
};

/** Moves the cutter along \p program and finds its contacts with the scan. A run of feed moves between rapids or links is a pass. Blocks
 *  at its begin that come down to the surface, or are in the air, are leads, and so at its end. \p program: sections of leads become
 *  LeadIn and LeadOut. */
ProgramPath programPath(const ReferenceSurface& reference, const ProgramPathSettings& settings, MachineProgram& program);

} // namespace pcl_spiral
