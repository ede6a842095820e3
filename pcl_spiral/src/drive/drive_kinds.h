// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The passes of each kind, before their axes are set. Private.
 */
#pragma once

#include <pcl_spiral/common/drive_pass.h>
#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/common/status.h>
#include <pcl_spiral/drive/drive_settings.h>
#include <pcl_spiral/graph/impl/surface_graph.h>
#include <pcl_spiral/surface/surface.h>

#include <vector>

namespace pcl_spiral {

/** An extent divided into equal steps, none larger than the given one. */
struct EqualSteps {
  double step = 0.0;
  std::vector<double> middles; ///< of each step
};

EqualSteps equalSteps(double low, double high, double most);

/** Refuses a path of too many \p points, or one that needs more memory than there is, for the points or for the
 *  \p crossings of lines with edges. */
Status checkDriveSize(double points, double crossings, const DriveSettings& settings);

/** Points at equal arc length along a line, at most \p spacing apart; the ends of an open line are
 *  kept. */
DrivePass passAlong(const Polyline& line, bool closed, double spacing);

/** Whether the cutter is a ball on a cylinder. */
inline bool
hasBallEnd(const CutterShape& cutter)
{
  return cutter.corner_radius == cutter.radius && cutter.flank_angle == 0.0;
}

/** Normal of the section planes: across the tool axis and the direction of the passes; unit. */
Eigen::Vector3d acrossPlanes(const DriveSettings& settings);

/** Points, length and largest step of the axes of finished passes. */
void measureDrive(const DrivePasses& passes, DriveReport& report);

Status planSections(const Surface& surface, const DriveSettings& settings, DrivePasses& passes, DriveReport& report);

/** Helix, rings or arcs about report.column. */
Status planRings(const DriveSettings& settings, DrivePasses& passes, DriveReport& report);

Status planOffsets(const SurfaceGraph& graph, const DriveSettings& settings, const ProgressCallback& progress, DrivePasses& passes,
                   DriveReport& report);

/** Axes of all points. \p graph may be empty for fixed axes. */
Status setAxes(const SurfaceGraph& graph, const DriveSettings& settings, const ProgressCallback& progress, DrivePasses& passes,
               DriveReport& report);

} // namespace pcl_spiral
