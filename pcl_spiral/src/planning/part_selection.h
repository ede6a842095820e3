// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Takes the points of the part out of a scan.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/planning/part_choice.h>
#include <pcl_spiral/surface/surface.h>

#include <pcl/pcl_base.h>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** A scan whose part is chosen, and how its side is found, to know where the ball stands. */
struct WholeScan {
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr cloud;
  pcl::PointCloud<pcl::Normal>::ConstPtr normals; ///< one for each point; null: none
  SurfaceSettings settings;                       ///< of these: side, threads, largest_part
  pcl::IndicesPtr indices;                        ///< points of the part; null: all
};

/** Largest lean of the shank from the normal that planner and judge look at, degrees: one that leans more would touch the surface. */
constexpr double most_lean = 60.0;

/** The tool that goes over a scan. */
struct PartTool {
  double radius = 0.0; ///< of the ball, mm; 0: any cutter, looked at later
  double lean = 0.0;   ///< of its axis from the normal, degrees
};

/** Which strips are left uncut. */
struct StripChoice {
  double width = 0.0;                   ///< point spacings: narrower ones; 0: none
  std::vector<std::size_t> cut;         ///< but not those with these numbers
  Surface::ConstPtr* surface = nullptr; ///< where the surface with the strips is kept from try to try; null: it is not kept
};

/** Finds the points of the part: those inside crop and region at which \p tool can touch without entering a keep-out, its shank (see
 *  ball_way.h) without touching what was scanned there (radius 0: those outside of keep-outs). The narrow \p strips beside keep-outs are
 *  left out, too; they are no warnings. Fails if no point is left (InvalidArgument; InvalidInput if the ball has no room beside the
 *  keep-outs), on a polygon that is no area, and if the points form no surface. */
Status choosePart(const WholeScan& scan, const PartChoice& choice, const PartTool& tool, const StripChoice& strips, ChosenPart& part);

} // namespace pcl_spiral
